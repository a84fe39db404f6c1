#include "scene/health/health_view.hpp"

#include <algorithm>
#include <cmath>

#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr std::uint64_t kFewestSteps = 8;

double reach_from_center(const World& world, BodyId body, Vec2 center) {
    float reach = 0.0f;
    for (const ShapeId shape : world.shapes(body))
        reach = std::max(reach, farthest_distance(world.shape(shape), center));
    return double{reach};
}

}  // namespace

double HealthView::gravity() const { return length(DVec2(world().def().gravity)); }

std::uint64_t HealthView::steps_to_sleep() const {
    const double steps = double{limits_.time_to_sleep} * double{world().def().steps_per_second};
    return std::max(kFewestSteps, static_cast<std::uint64_t>(std::ceil(steps)));
}

std::string HealthView::name(std::size_t body) const { return display_name(*built_, body); }

void HealthView::update(const SceneWorld& built) {
    is_first_ = built_ == nullptr;
    built_ = &built;
    limits_ = world_limits(built.world.def());
    std::swap(before_, bodies_);
    bodies_ = before_;
    add_new_bodies();
    for (std::size_t i = 0; i < bodies_.size(); ++i) update_body(i);
    contacts_ = built.world.contacts();
    std::erase_if(contacts_,
                  [this](const ContactPoint& contact) { return !knows(contact.body_a) || !knows(contact.body_b); });
    mark_contacts();
}

void HealthView::mark_contacts() {
    for (const ContactPoint& contact : contacts_)
        for (const BodyId id : {contact.body_a, contact.body_b})
            if (contact.normal_impulse > 0.0f || contact.separation <= 0.0f) bodies_[index_of(id)].touches = true;
    for (const ContactBegin& begin : world().events().contact_begins)
        for (const ShapeId shape : {begin.shape_a, begin.shape_b})
            if (world().is_valid(shape) && knows(world().body(shape)))
                bodies_[index_of(world().body(shape))].is_hit = true;
}

void HealthView::add_new_bodies() {
    for (std::size_t i = bodies_.size(); i < built_->bodies.size(); ++i) {
        const BodyId id = built_->bodies[i].id;
        bodies_.push_back({.id = id, .born = step()});
        index_.resize(std::max<std::size_t>(index_.size(), std::size_t{id.index} + 1), kNoBody);
        index_[id.index] = i;
    }
}

void HealthView::update_body(std::size_t body) {
    SeenBody& seen = bodies_[body];
    const bool existed = seen.exists;
    seen.exists = world().is_valid(seen.id);
    seen.touches = seen.is_hit = false;
    if (!seen.exists) return;
    seen.is_dynamic = world().type(seen.id) == BodyType::dynamic_body && world().is_enabled(seen.id);
    seen.is_awake = seen.is_dynamic && world().is_awake(seen.id);
    seen.state = world().state(seen.id);
    const BodyMass mass = world().mass(seen.id);
    seen.center = transform_point(seen.state.pose, mass.center);
    if (!existed) {
        seen.mass = double{mass.mass};
        seen.reach = reach_from_center(world(), seen.id, mass.center);
        seen.smallest = smallest_extent(world(), seen.id);
        seen.largest = largest_extent(world(), seen.id);
    }
    seen.sleep_speed = length(DVec2(seen.state.velocity)) + std::abs(double{seen.state.angular_velocity}) * seen.reach;
}

}  // namespace tumble::scene
