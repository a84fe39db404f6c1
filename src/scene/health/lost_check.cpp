// Bodies that have fallen below everything that could stop them.
#include <algorithm>
#include <cmath>
#include <string>

#include "scene/health/health_check.hpp"
#include "scene/model/display.hpp"

namespace tumble {

namespace {

constexpr double kTypicalBodies = 10.0;  // that a lost body is at least below the grounds

// Extent of all static and kinematic shapes along the direction of gravity (m, positive downwards).
struct GroundExtent {
    double highest = HUGE_VAL, deepest = -HUGE_VAL;
};

GroundExtent extent_of_grounds(const World& world, DVec2 down) {
    GroundExtent extent;
    for (const BodyId body : world.bodies()) {
        if (world.type(body) == BodyType::dynamic_body) continue;
        for (const ShapeId shape : world.shapes(body)) {
            if (world.is_sensor(shape)) continue;
            const Aabb box = bounds(world.shape(shape), world.state(body).pose);
            for (const Vec2 corner :
                 {box.lower, box.upper, Vec2{box.lower.x, box.upper.y}, Vec2{box.upper.x, box.lower.y}}) {
                extent.highest = std::min(extent.highest, dot(DVec2(corner), down));
                extent.deepest = std::max(extent.deepest, dot(DVec2(corner), down));
            }
        }
    }
    return extent;
}

}  // namespace

std::vector<std::size_t> find_lost_bodies(const SceneWorld& built) {
    const World& world = built.world;
    const DVec2 gravity(world.def().gravity);
    if (!(length(gravity) > 0.0)) return {};
    const DVec2 down = (1.0 / length(gravity)) * gravity;
    const GroundExtent grounds = extent_of_grounds(world, down);
    const double limit =
        grounds.deepest + std::max(grounds.deepest - grounds.highest, kTypicalBodies * double{world.def().scale});
    std::vector<std::size_t> lost;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) {
        const BodyId body = built.bodies[i].id;
        if (!world.is_valid(body) || world.type(body) != BodyType::dynamic_body || !std::isfinite(limit)) continue;
        if (dot(world.state(body).pose.position, down) > limit) lost.push_back(i);
    }
    return lost;
}

namespace scene {

namespace {

class LostCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        last_held_.resize(view.bodies().size());
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            if (!body.exists || !body.is_dynamic) continue;
            if (!view.was_there(i) || body.touches)
                last_held_[i] = {view.step(), view.world().time(), body.center, body.touches || last_held_[i].touched};
        }
    }

    void report(const HealthView& view, std::vector<HealthFinding>& findings) const override {
        Culprits culprits;
        for (const std::size_t i : find_lost_bodies(view.built())) {
            if (i >= last_held_.size()) break;  // spawned in a step that diverged: it was in no state
            const Culprit culprit{{i}, {view.source(i)}};
            const Held& held = last_held_[i];
            const DVec2 position = view.bodies()[i].center;
            const double fall = length(position - held.center);
            if (!culprits.is_worst(culprit, fall)) continue;
            const std::string touched =
                held.touched ? "last touched something at " + brief(held.time) + " s" : "has touched nothing";
            culprits.set(culprit,
                         {.check = "lost",
                          .subject = view.name(i),
                          .text = view.name(i) + " has fallen below all static and kinematic shapes: it is at " +
                                  brief(position) + " at the end, and " + touched,
                          .remedy = "Close the gap or make the ground wider, turn a one-sided chain around, or remove "
                                    "the body by a \"despawn\" event.",
                          .step = held.step,
                          .time = held.time,
                          .bodies = {view.bodies()[i].id},
                          .point = held.center,
                          .value = fall,
                          .unit = "m"});
        }
        culprits.append_to(findings);
    }

private:
    struct Held {
        std::uint64_t step = 0;
        double time = 0.0;
        DVec2 center;
        bool touched = false;
    };
    std::vector<Held> last_held_;  // [built bodies]: the last state in which the body touched something, or its first
};

}  // namespace

std::unique_ptr<HealthCheck> make_lost_check() { return std::make_unique<LostCheck>(); }

}  // namespace scene

}  // namespace tumble
