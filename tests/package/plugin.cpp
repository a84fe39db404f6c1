#include "tumble/world.hpp"

// The height in m of a ball, two seconds after it was dropped onto a floor.
extern "C" [[gnu::visibility("default")]] double tumble_plugin_height() {
    tumble::World world;
    const tumble::BodyId floor = world.create_body({.type = tumble::BodyType::static_body});
    world.add_shape(floor, {.shape = tumble::make_box({20.0f, 1.0f})});
    const tumble::BodyId ball = world.create_body({.pose = {{0.0, 2.0}, {}}});
    world.add_shape(ball, {.shape = tumble::make_circle(0.5f)});
    for (int i = 0; i < 120; ++i) world.step();
    return world.state(ball).pose.position.y;
}
