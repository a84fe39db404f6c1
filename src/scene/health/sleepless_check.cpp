// Bodies at rest that stay awake, with the body that keeps their island awake.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kMostMarked = 8;  // bodies at rest in the picture

// The body that keeps an island awake, and the reason.
struct Keeper {
    std::size_t body = 0;
    std::string reason;
    std::string remedy;
};

class SleepCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        quiet_.resize(view.bodies().size());
        moving_.resize(view.bodies().size());
        const double part = 1.0 / static_cast<double>(view.patience());
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            const bool is_quiet = body.exists && body.is_awake && body.sleep_speed < double{view.limits().rest_speed};
            quiet_[i] = is_quiet ? quiet_[i] + 1 : 0;
            moving_[i] += part * ((is_quiet || !body.is_awake ? 0.0 : 1.0) - moving_[i]);
        }
    }

    void report(const HealthView& view, std::vector<HealthFinding>& findings) const override {
        if (!view.world().def().sleeping) return;
        const std::uint64_t least = view.patience();
        std::map<int, std::vector<std::size_t>> islands = islands_of(view);
        Culprits culprits;
        for (const auto& [number, members] : islands) {
            std::vector<std::size_t> resting;
            for (const std::size_t i : members)
                if (quiet_[i] >= least) resting.push_back(i);
            if (resting.empty()) continue;
            if (const std::optional<Keeper> keeper = find_keeper(view, members)) note(view, *keeper, resting, culprits);
        }
        culprits.append_to(findings);
    }

private:
    // The built bodies of each awake island.
    static std::map<int, std::vector<std::size_t>> islands_of(const HealthView& view) {
        const std::vector<int> numbers = view.world().islands();
        const std::span<const BodyId> ids = view.world().bodies();
        std::map<int, std::vector<std::size_t>> islands;
        for (std::size_t k = 0; k < ids.size(); ++k)
            if (numbers[k] >= 0 && view.knows(ids[k]) && view.world().is_awake(ids[k]))
                islands[numbers[k]].push_back(view.index_of(ids[k]));
        return islands;
    }

    std::optional<Keeper> find_keeper(const HealthView& view, const std::vector<std::size_t>& members) const {
        for (const std::size_t i : members)
            if (!view.world().definition(view.bodies()[i].id).allow_sleep)
                return Keeper{i, "must not sleep (\"allow_sleep\": false)", "Remove \"allow_sleep\": false."};
        for (const std::size_t i : members)
            if (const std::optional<std::size_t> mover = moving_support(view, i))
                return Keeper{*mover, "is kinematic and " + motion_text(view.bodies()[*mover].state),
                              "Set its velocity to 0 when it has arrived."};
        if (std::ranges::any_of(members, [&](std::size_t i) { return moving_[i] > 0.0; }))
            return driven_keeper(view, members);
        return drifting_keeper(view, members);
    }

    static std::string motion_text(const BodyState& state) {
        const double speed = length(DVec2(state.velocity));
        return speed > 0.0 ? "moves at " + brief(speed) + " m/s"
                           : "turns at " + brief(std::abs(double{state.angular_velocity}) * kDegrees) + " degrees/s";
    }

    // Nothing slows down an island that touches and is joined to no body at rest.
    static std::optional<Keeper> drifting_keeper(const HealthView& view, const std::vector<std::size_t>& members) {
        for (const std::size_t i : members)
            for (const BodyId other : neighbours(view.world(), view.bodies()[i].id))
                if (view.world().type(other) != BodyType::dynamic_body || !view.knows(other)) return std::nullopt;
        const std::size_t fastest =
            *std::ranges::max_element(members, {}, [&](std::size_t i) { return view.bodies()[i].sleep_speed; });
        return Keeper{fastest,
                      "drifts at " + brief(view.bodies()[fastest].sleep_speed) + " m/s, and nothing slows it down",
                      "Give it a \"linear_damping\" and an \"angular_damping\", or a velocity of 0."};
    }

    // The body of the island that moves most of those that a motor drives.
    std::optional<Keeper> driven_keeper(const HealthView& view, const std::vector<std::size_t>& members) const {
        std::optional<Keeper> keeper;
        for (const std::size_t i : members) {
            if (!(moving_[i] > (keeper ? moving_[keeper->body] : 0.0))) continue;
            for (const JointId id : view.world().joints(view.bodies()[i].id)) {
                const auto found = std::ranges::find(view.built().joints, id, &SceneJointInstance::id);
                if (found == view.built().joints.end() || !has_drive(view.world().joint(id))) continue;
                const auto joint = static_cast<std::size_t>(found - view.built().joints.begin());
                keeper = Keeper{i, "is driven by the motor of " + display_joint_name(view.built(), joint),
                                "Stop the motor when it has done its work, or keep bodies at rest away from it."};
            }
        }
        return keeper;
    }

    static bool has_drive(const JointDef& joint) {
        return std::visit(
            [](const auto& def) {
                if constexpr (requires { def.motor; }) return def.motor && def.motor->speed != 0.0f;
                return std::is_same_v<std::decay_t<decltype(def)>, MotorJointDef>;
            },
            joint);
    }

    // A moving kinematic body that touches the body or is joined to it.
    static std::optional<std::size_t> moving_support(const HealthView& view, std::size_t body) {
        for (const BodyId other : neighbours(view.world(), view.bodies()[body].id))
            if (view.knows(other) && view.world().type(other) == BodyType::kinematic_body &&
                view.bodies()[view.index_of(other)].sleep_speed > 0.0)
                return view.index_of(other);
        return std::nullopt;
    }

    // The bodies that touch a body or are joined to it.
    static std::vector<BodyId> neighbours(const World& world, BodyId body) {
        std::vector<BodyId> found;
        for (const ContactPoint& contact : world.contacts(body))
            found.push_back(contact.body_a == body ? contact.body_b : contact.body_a);
        for (const JointId joint : world.joints(body))
            std::visit([&](const auto& def) { found.push_back(def.body_a == body ? def.body_b : def.body_a); },
                       world.joint(joint));
        return found;
    }

    void note(const HealthView& view, const Keeper& keeper, const std::vector<std::size_t>& resting,
              Culprits& culprits) const {
        const Culprit culprit{{keeper.body}, {view.source(keeper.body)}};
        const std::uint64_t steps =
            quiet_[*std::ranges::max_element(resting, {}, [&](std::size_t i) { return quiet_[i]; })];
        if (!culprits.is_worst(culprit, static_cast<double>(steps))) return;
        const double seconds = static_cast<double>(steps) * view.step_duration();
        const double limit = static_cast<double>(view.patience()) * view.step_duration();
        const bool is_alone = resting.size() == 1 && resting.front() == keeper.body;
        HealthFinding finding{.check = "sleepless",
                              .subject = view.name(keeper.body),
                              .remedy = keeper.remedy,
                              .step = view.step(),
                              .time = view.world().time(),
                              .bodies = {view.bodies()[keeper.body].id},
                              .point = view.bodies()[keeper.body].center,
                              .value = seconds,
                              .limit = limit,
                              .unit = "s"};
        finding.text = view.name(keeper.body) + " " + keeper.reason;
        if (is_alone)
            finding.text += ": it has been at rest for " + brief(seconds) + " s and is awake";
        else
            finding.text += ", and keeps " +
                            view.name(resting.front() == keeper.body ? resting.back() : resting.front()) +
                            (resting.size() > 1 ? " and " + std::to_string(resting.size() - 1) + " more" : "") +
                            " awake, at rest for " + brief(seconds) + " s";
        for (const std::size_t i : resting)
            if (finding.bodies.size() < kMostMarked && i != keeper.body) finding.bodies.push_back(view.bodies()[i].id);
        culprits.set(culprit, std::move(finding));
    }

    std::vector<std::uint64_t> quiet_;  // [built bodies] steps for which it has been at rest and awake
    std::vector<double> moving_;        // [built bodies] part of the last steps in which it moved
};

}  // namespace

std::unique_ptr<HealthCheck> make_sleep_check() { return std::make_unique<SleepCheck>(); }

}  // namespace tumble::scene
