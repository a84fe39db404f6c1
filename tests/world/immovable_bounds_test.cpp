// Static and kinematic shapes bound the motion of bodies, where the work of the solver and of impacts ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// The inside of four walls of 1 m, a square with a side of 10 m about the origin, all at one velocity.
void add_box_of_walls(World& world, BodyType type, Vec2 velocity) {
    for (const double side : {-5.5, 5.5})
        for (const bool is_upright : {true, false}) {
            const DVec2 at = is_upright ? DVec2{side, 0.0} : DVec2{0.0, side};
            const BodyId wall = add_body(world, type, at, make_box(is_upright ? Vec2{1.0f, 12.0f} : Vec2{12.0f, 1.0f}));
            if (type == BodyType::kinematic_body) world.set_velocity(wall, velocity, 0.0f);
        }
}

std::vector<BodyId> fill_box(World& world, double shift) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < 49; ++i) {
        const float size = 0.2f + 0.02f * static_cast<float>(i % 5);
        const DVec2 at{1.2 * (i % 7) - 3.6 + 0.01 * (i % 3) + shift * (i % 4), 1.2 * (i / 7) - 3.6};
        const Shape shape = i % 2 == 0 ? make_circle(size) : make_box({2.0f * size, 1.4f * size});
        bodies.push_back(add_dynamic(world, at, shape, {}, 0.3 * i));
    }
    return bodies;
}

// Steps for a second: how far from the middle of the box the farthest body is then, along x or y. `shift` (m) moves the
// bodies at the start.
double farthest_in_box(const WorldDef& def, BodyType walls, Vec2 velocity, double shift = 0.0) {
    World world(def);
    add_box_of_walls(world, walls, velocity);
    const std::vector<BodyId> bodies = fill_box(world, shift);
    run(world, static_cast<int>(def.steps_per_second));
    double farthest = 0.0;
    for (const BodyId body : bodies) {
        const DVec2 at = world.state(body).pose.position - DVec2(velocity);
        farthest = std::max({farthest, std::abs(at.x), std::abs(at.y)});
    }
    return farthest;
}

}  // namespace

// Gravity moves a ball by up to 5 m in a step, 25 times its radius.
TEST_CASE("in order: 49 bodies stay in a closed box at high gravity, low rates and one sub-step") {
    for (const float rate : {10.0f, 30.0f, 60.0f})
        for (const float gravity : {100.0f, 1000.0f})
            for (const int substeps : {1, 4}) {
                CAPTURE(rate);
                CAPTURE(gravity);
                CAPTURE(substeps);
                const WorldDef def{.gravity = {0.0f, -gravity}, .steps_per_second = rate, .substeps = substeps};
                for (const int i : {0, 1, 2, 3, 4, 5, 56, 100}) {  // at 56 and 100 a disc turns while it sinks in
                    CAPTURE(i);
                    CHECK(farthest_in_box(def, BodyType::static_body, {}, 1e-4 * i) <= 5.0);
                }
            }
}

TEST_CASE("in order: 49 bodies stay in a closed box whose walls move at 10 m/s") {
    for (const float rate : {30.0f, 60.0f})
        for (const Vec2 velocity : {Vec2{10.0f, 0.0f}, Vec2{0.0f, 10.0f}, Vec2{0.0f, -10.0f}}) {
            CAPTURE(rate);
            CAPTURE(velocity.x);
            CAPTURE(velocity.y);
            const WorldDef def{.gravity = {0.0f, -100.0f}, .steps_per_second = rate, .substeps = 1};
            CHECK(farthest_in_box(def, BodyType::kinematic_body, velocity) <= 5.0);
        }
}

TEST_CASE("in order: a ball that bounces off the ceiling flies over a partition within one step") {
    constexpr SurfaceMaterial elastic{.friction = 0.0f, .restitution = 1.0f};
    World world = weightless();
    add_static(world, {0.0, 0.0}, make_box({0.1f, 2.0f}));
    add_static(world, {0.0, 2.5}, make_box({20.0f, 1.0f}), elastic);
    const BodyId ball = add_dynamic(world, {-1.0, 0.4}, make_circle(0.1f), elastic);
    world.set_velocity(ball, {120.0f, 180.0f}, 0.0f);
    world.step();  // up 1.5 m to the ceiling and down again, 2 m along
    CHECK(near(world.state(ball).pose.position.x, 1.0, absolute(1e-4)));
    CHECK(near(world.state(ball).pose.position.y, 0.4, absolute(1e-4)));
    CHECK(near(world.state(ball).velocity.x, 120.0, kFloat));
    CHECK(near(world.state(ball).velocity.y, -180.0, kFloat));
}
