#include "scene/expressions/contact_state.hpp"

#include <algorithm>
#include <limits>

#include "tumble/distance.hpp"

namespace tumble::scene {

namespace {

// The least distance between a sensor of one body and a solid shape of the other.
double sensor_gap(const World& world, BodyId a, BodyId b) {
    double gap = std::numeric_limits<double>::infinity();
    for (const ShapeId one : world.shapes(a))
        for (const ShapeId other : world.shapes(b))
            if (world.is_sensor(one) != world.is_sensor(other))
                gap = std::min(
                    gap,
                    distance(world.shape(one), world.state(a).pose, world.shape(other), world.state(b).pose).distance);
    return gap;
}

bool has_sensor(const World& world, BodyId body) {
    return std::ranges::any_of(world.shapes(body), [&](ShapeId shape) { return world.is_sensor(shape); });
}

template <class Event>
bool any_between(const World& world, const std::vector<Event>& events, ShapeId Event::*first, ShapeId Event::*second,
                 BodyId a, BodyId b) {
    return std::ranges::any_of(events, [&](const Event& event) {
        const ShapeId one = event.*first, other = event.*second;
        if (!world.is_valid(one) || !world.is_valid(other)) return false;
        const BodyId p = world.body(one), q = world.body(other);
        return (p == a && q == b) || (p == b && q == a);
    });
}

}  // namespace

double gap_between(const World& world, BodyId a, BodyId b) {
    const DistanceResult nearest = world.distance(a, b).nearest;  // of the shapes that are no sensors
    const double solid =
        nearest.status == DistanceStatus::invalid ? std::numeric_limits<double>::infinity() : nearest.distance;
    return std::max(std::min(solid, sensor_gap(world, a, b)), 0.0);
}

bool are_touching(const World& world, BodyId a, BodyId b) {
    const StepEvents& events = world.events();
    if (any_between(world, events.contact_begins, &ContactBegin::shape_a, &ContactBegin::shape_b, a, b) ||
        any_between(world, events.sensor_begins, &SensorEvent::sensor, &SensorEvent::visitor, a, b))
        return true;
    const auto touches = [&](const ContactPoint& contact) {
        const BodyId other = contact.body_a == a ? contact.body_b : contact.body_a;
        return other == b && (contact.separation <= 0.0f || contact.normal_impulse > 0.0f);
    };
    if (std::ranges::any_of(world.contacts(a), touches)) return true;
    return (has_sensor(world, a) || has_sensor(world, b)) && sensor_gap(world, a, b) <= 0.0;
}

}  // namespace tumble::scene
