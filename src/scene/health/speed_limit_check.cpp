// Bodies at the speed limit of the step: what is faster is cut off.
#include <cmath>
#include <string>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kNearly = 0.999;  // of a limit: a clamped velocity is below it by rounding

class SpeedCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        spinning_.resize(view.bodies().size());
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            if (!body.exists || !body.is_awake) continue;
            note(view, i, length(DVec2(body.state.velocity)), double{view.limits().max_speed}, false);
            const double turn = std::abs(double{body.state.angular_velocity}) * view.step_duration();
            const double most = double{view.limits().max_rotation};
            const bool spins = turn > kNearly * most && !view.world().definition(body.id).allow_fast_rotation;
            spinning_[i] = spins ? spinning_[i] + 1 : 0;
            if (spinning_[i] >= view.steps_to_sleep()) note(view, i, turn * kDegrees, most * kDegrees, true);
        }
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void note(const HealthView& view, std::size_t i, double value, double limit, bool turns) {
        if (!(value > kNearly * limit)) return;
        const Culprit culprit{{i}, {view.source(i)}};
        if (!culprits_.is_worst(culprit, value / limit)) return;
        const std::string text =
            turns ? view.name(i) + " turns by " + brief(value) + " degrees in a step, the most that a step allows"
                  : view.name(i) + " has " + brief(value) + " m/s: a step limits speeds to " + brief(limit) + " m/s";
        const std::string remedy =
            turns
                ? "Set \"allow_fast_rotation\" if the body is round, use more \"steps_per_second\", or turn it slower."
                : "Lower the velocity, the impulse or the force that drives it; in a world of large bodies set "
                  "\"scale\".";
        culprits_.set(culprit, {.check = "speed_limit",
                                .subject = view.name(i),
                                .text = text,
                                .remedy = remedy,
                                .step = view.step(),
                                .time = view.world().time(),
                                .bodies = {view.bodies()[i].id},
                                .point = view.bodies()[i].center,
                                .value = value,
                                .limit = limit,
                                .unit = turns ? "degrees" : "m/s"});
    }

    std::vector<std::uint64_t> spinning_;  // [built bodies] steps for which it has turned at the limit
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_speed_check() { return std::make_unique<SpeedCheck>(); }

}  // namespace tumble::scene
