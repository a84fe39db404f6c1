#include "scene/expressions/energy.hpp"

namespace tumble::scene {

Energy energy_of(const World& world, BodyId body) {
    if (world.type(body) != BodyType::dynamic_body) return {};
    const BodyMass own = world.mass(body);
    const BodyState state = world.state(body);
    const DVec2 velocity(state.velocity), gravity(world.def().gravity);
    const double mass = double{own.mass}, turn = double{state.angular_velocity};
    const double weight = mass * double{world.definition(body).gravity_scale};
    return {0.5 * mass * dot(velocity, velocity) + 0.5 * double{own.inertia} * turn * turn,
            -weight * dot(gravity, transform_point(state.pose, own.center))};
}

Energy energy_of(const World& world) {
    Energy sum;
    for (const BodyId body : world.bodies()) {
        const Energy energy = energy_of(world, body);
        sum.kinetic += energy.kinetic;
        sum.potential += energy.potential;
    }
    return sum;
}

DVec2 momentum_of(const World& world) {
    DVec2 sum;
    for (const BodyId body : world.bodies())
        if (world.type(body) == BodyType::dynamic_body)
            sum = sum + double{world.mass(body).mass} * DVec2(world.state(body).velocity);
    return sum;
}

}  // namespace tumble::scene
