// Energy that appears without work: what bodies that were created inside each other, or contradicting constraints, give
// to a scene.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kGainedPart = 0.1;  // of the largest kinetic energy so far

bool stores_energy(const JointDef& joint) {
    return std::visit(
        [](const auto& def) {
            if constexpr (requires { def.linear_spring; }) return def.linear_spring || def.angular_spring;
            if constexpr (std::is_same_v<std::decay_t<decltype(def)>, MouseJointDef>) return true;
            if constexpr (requires { def.spring.has_value(); }) return def.spring.has_value();
            return false;
        },
        joint);
}

// Energy that SceneWorld::work does not count: of springs, of kinematic bodies, of belts.
bool has_other_sources(const HealthView& view) {
    const World& world = view.world();
    if (std::ranges::any_of(world.joints(), [&](JointId id) { return stores_energy(world.joint(id)); })) return true;
    return std::ranges::any_of(view.bodies(), [&](const SeenBody& body) {
        if (!body.exists) return false;
        if (world.type(body.id) == BodyType::kinematic_body && body.sleep_speed > 0.0) return true;
        return std::ranges::any_of(world.shapes(body.id),
                                   [&](ShapeId shape) { return world.material(shape).tangent_speed != 0.0f; });
    });
}

// What bodies at rest may have, J: contacts store the work of lifting each body by a sag that is just not visible, and
// each may move by up to the speed of rest, which is all that there is without gravity.
double resting_energy(const HealthView& view) {
    const double rest_speed{view.limits().rest_speed};
    double sum = 0.0;
    for (const SeenBody& body : view.bodies()) {
        if (!body.exists || !body.is_dynamic) continue;
        sum += 0.5 * body.mass * rest_speed * rest_speed;
        if (std::isfinite(body.smallest)) sum += body.mass * view.gravity() * kVisibleSag * body.smallest;
    }
    return sum;
}

// The velocity after the step of a body on which gravity and damping alone act, sub-step by sub-step.
DVec2 free_velocity(const HealthView& view, const SeenBody& before) {
    const WorldDef& world = view.world().def();
    const BodyDef body = view.world().definition(before.id);
    const double substep = view.step_duration() / world.substeps;
    const double decay = 1.0 / (1.0 + substep * double{body.linear_damping});
    const DVec2 fall = substep * double{body.gravity_scale} * DVec2(world.gravity);
    DVec2 velocity(before.state.velocity);
    for (int i = 0; i < world.substeps; ++i) velocity = decay * (velocity + fall);
    return velocity;
}

class EnergyCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        observe_world(view);
        if (!view.is_first())
            for (std::size_t i = 0; i < view.bodies().size(); ++i)
                if (view.bodies()[i].exists && view.bodies()[i].is_awake && view.was_there(i)) observe_body(view, i);
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void observe_world(const HealthView& view) {
        const Energy energy = view.world().energy();
        const double total = energy.total() - view.built().work;
        const std::size_t count = view.world().bodies().size();
        const bool is_known = last_ && count == count_ && !has_other_sources(view);
        const double gain = is_known ? total - *last_ : 0.0;
        last_ = total;
        count_ = count;
        most_kinetic_ = std::max(most_kinetic_, energy.kinetic);
        const double limit = kGainedPart * most_kinetic_ + resting_energy(view);
        if (gain > limit) note_gain(view, gain, limit);
    }

    static bool is_held(const HealthView& view, const SeenBody& body) {
        return body.touches || body.is_hit || !view.world().joints(body.id).empty();
    }

    // A body that nothing touches gets its velocity from an event.
    void observe_body(const HealthView& view, std::size_t i) {
        const SeenBody &body = view.bodies()[i], &before = view.bodies_before()[i];
        const DVec2 velocity(body.state.velocity);
        const double limit = body.smallest / view.step_duration();
        if (!(length(velocity - DVec2(before.state.velocity)) > limit)) return;
        const double change = length(velocity - free_velocity(view, before));
        if (!(change > limit) || is_held(view, body) || is_held(view, before)) return;
        const Culprit culprit{{i}, {view.source(i)}};
        if (!culprits_.is_worst(culprit, change / limit)) return;
        culprits_.set(culprit, {.check = "energy",
                                .subject = view.name(i),
                                .text = view.name(i) + " is kicked: its velocity changes by " + brief(change) +
                                        " m/s in one step, more than its thickness in each step",
                                .remedy = "Check the impulse, force or velocity of the event at this time, and spread "
                                          "it over several steps.",
                                .step = view.step(),
                                .time = view.world().time(),
                                .bodies = {body.id},
                                .point = body.center,
                                .value = change,
                                .limit = limit,
                                .unit = "m/s"});
    }

    void note_gain(const HealthView& view, double gain, double limit) {
        if (!culprits_.is_worst({}, gain)) return;
        const std::size_t body = fastest_riser(view);
        culprits_.set({}, {.check = "energy",
                           .subject = view.name(body),
                           .text = "the world gains " + brief(gain) + " J in one step without work; " +
                                   view.name(body) + " gets most of it",
                           .remedy = "Look for bodies that overlap and for joints that start apart or contradict each "
                                     "other, or use more \"substeps\".",
                           .step = view.step(),
                           .time = view.world().time(),
                           .bodies = {view.bodies()[body].id},
                           .point = view.bodies()[body].center,
                           .value = gain,
                           .limit = limit,
                           .unit = "J"});
    }

    // The body whose energy has grown most in the step.
    static std::size_t fastest_riser(const HealthView& view) {
        const DVec2 gravity(view.world().def().gravity);
        std::size_t found = 0;
        double most = -HUGE_VAL;
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            if (!body.exists || !body.is_dynamic || !view.was_there(i)) continue;
            const SeenBody& before = view.bodies_before()[i];
            const DVec2 now(body.state.velocity), last(before.state.velocity);
            const double gained =
                body.mass * (0.5 * (length_sq(now) - length_sq(last)) - dot(gravity, body.center - before.center));
            if (gained > most) most = gained, found = i;
        }
        return found;
    }

    std::optional<double> last_;  // J: the energy less the work
    std::size_t count_ = 0;       // of bodies
    double most_kinetic_ = 0.0;   // J
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_energy_check() { return std::make_unique<EnergyCheck>(); }

}  // namespace tumble::scene
