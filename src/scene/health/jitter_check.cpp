// Bodies that shake where they are: their velocity changes its sign every few steps while they go nowhere.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kStay = 0.1;                 // of the smallest extent: a body that stays within it goes nowhere
constexpr std::uint64_t kShortPeriod = 8;     // steps: a motion this fast is the solver's, not one of the scene
constexpr std::uint64_t kPatientWindows = 4;  // a pile that settles shakes for less

// What a body did since the window began.
struct JitterWindow {
    std::uint64_t steps = 0;
    std::uint64_t reversals = 0;
    double fastest = 0.0;    // m/s, of a reversal
    DVec2 lower, upper;      // of the centre of mass
    DVec2 moving;            // the last velocity above the speed of rest, m/s
    double turning = 0.0;    // the same of the rotation, at the farthest point, m/s
    std::uint64_t held = 0;  // steps in which it touched something or was joined
};

class JitterCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        windows_.resize(view.bodies().size());
        shaken_.resize(view.bodies().size());
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            if (!body.exists || !body.is_awake || !view.was_there(i)) {
                windows_[i] = {};
                shaken_[i] = 0;
                continue;
            }
            observe_body(view, body, windows_[i]);
            if (windows_[i].steps < view.steps_to_sleep()) continue;
            shaken_[i] = shakes(body, windows_[i]) ? shaken_[i] + 1 : 0;
            if (shaken_[i] >= kPatientWindows) note(view, i);
            windows_[i] = window_after(windows_[i]);
        }
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    // The velocity may reverse in its first step.
    static JitterWindow window_after(const JitterWindow& before) {
        JitterWindow window;
        window.moving = before.moving;
        window.turning = before.turning;
        return window;
    }

    static void observe_body(const HealthView& view, const SeenBody& body, JitterWindow& window) {
        if (window.steps++ == 0) window.lower = window.upper = body.center;
        window.lower = {std::min(window.lower.x, body.center.x), std::min(window.lower.y, body.center.y)};
        window.upper = {std::max(window.upper.x, body.center.x), std::max(window.upper.y, body.center.y)};
        if (body.touches || !view.world().joints(body.id).empty()) ++window.held;
        // Between two directions may be a step that is slow.
        const double rest = double{view.limits().rest_speed};
        const DVec2 moving(body.state.velocity);
        const double turning = double{body.state.angular_velocity} * body.reach;
        double reversed = 0.0;
        if (length(moving) > rest) {
            if (dot(moving, window.moving) < 0.0) reversed = std::min(length(moving), length(window.moving));
            window.moving = moving;
        }
        if (std::abs(turning) > rest) {
            if (turning * window.turning < 0.0)
                reversed = std::max(reversed, std::min(std::abs(turning), std::abs(window.turning)));
            window.turning = turning;
        }
        if (reversed == 0.0) return;
        ++window.reversals;
        window.fastest = std::max(window.fastest, reversed);
    }

    static bool shakes(const SeenBody& body, const JitterWindow& window) {
        return 2 * window.held > window.steps && window.reversals > most_reversals(window) &&
               length(window.upper - window.lower) <= kStay * body.smallest;
    }

    // A motion of the shortest period has two reversals in each.
    static std::uint64_t most_reversals(const JitterWindow& window) { return 2 * window.steps / kShortPeriod; }

    void note(const HealthView& view, std::size_t i) {
        const SeenBody& body = view.bodies()[i];
        const JitterWindow& window = windows_[i];
        const Culprit culprit{{i}, {view.source(i)}};
        if (!culprits_.is_worst(culprit, window.fastest)) return;
        const double seconds = static_cast<double>(window.steps) * view.step_duration();
        culprits_.set(
            culprit,
            {.check = "jitter",
             .subject = view.name(i),
             .text = view.name(i) + " shakes at rest: its velocity reversed " + std::to_string(window.reversals) +
                     " times in " + brief(seconds) + " s, at up to " + brief(window.fastest) + " m/s",
             .remedy = "Look for what presses it from two sides: wrong anchors, a motor, a spring or an "
                       "overlap; else use more \"substeps\", or lower the mass ratio of the bodies that it "
                       "touches.",
             .step = view.step(),
             .time = view.world().time(),
             .bodies = {body.id},
             .point = body.center,
             .value = static_cast<double>(window.reversals) / seconds,
             .limit = static_cast<double>(most_reversals(window)) / seconds,
             .unit = "1/s"});
    }

    std::vector<JitterWindow> windows_;  // [built bodies]
    std::vector<std::uint64_t> shaken_;  // [built bodies] consecutive windows in which it shook
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_jitter_check() { return std::make_unique<JitterCheck>(); }

}  // namespace tumble::scene
