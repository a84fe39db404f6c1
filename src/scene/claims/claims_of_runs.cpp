// Claims on the time that a run takes, and on what only the check command can see.
#include <algorithm>
#include <bit>

#include "scene/claims/claims.hpp"
#include "scene/model/display.hpp"
#include "scene/model/step_time.hpp"

namespace tumble::scene {

namespace {

class StepTime final : public Claim {
public:
    explicit StepTime(const SceneExpectation& claim) : claim_(claim) {}

    void follow(const SceneWorld& built) override {
        const std::uint64_t step = built.world.step_count();
        const double rate = double{built.world.def().steps_per_second};
        if (step == 0 || step < first_step_at(claim_.from.value_or(0.0), rate)) return;
        if (claim_.until && step > first_step_at(*claim_.until, rate)) return;
        ms_ += built.world.counters().ms.step;
        ++steps_;
    }
    double excess(const SceneWorld&) override { return std::max(0.0, mean() - claim_.max_ms_per_step.value()); }
    std::string finding(const SceneWorld&) const override { return "a step takes " + brief(mean()) + " ms"; }
    std::vector<std::uint64_t> state() const override { return {std::bit_cast<std::uint64_t>(ms_), steps_}; }
    bool set_state(std::span<const std::uint64_t> state) override {
        if (state.size() != 2) return false;
        ms_ = std::bit_cast<double>(state[0]);
        steps_ = state[1];
        return true;
    }

private:
    double mean() const { return steps_ == 0 ? 0.0 : ms_ / static_cast<double>(steps_); }

    SceneExpectation claim_;
    double ms_ = 0.0;
    std::uint64_t steps_ = 0;
};

// Decided elsewhere.
class Undecided final : public Claim {
public:
    double excess(const SceneWorld&) override { return 0.0; }
    std::string finding(const SceneWorld&) const override { return "only the check command decides this"; }
};

}  // namespace

bool is_decided_by_watch(const SceneExpectation& claim) { return !claim.max_time_ratio && claim.picture.empty(); }

std::unique_ptr<Claim> make_claim_of_runs(const SceneExpectation& claim) {
    if (claim.max_ms_per_step) return std::make_unique<StepTime>(claim);
    if (!is_decided_by_watch(claim)) return std::make_unique<Undecided>();
    return nullptr;
}

}  // namespace tumble::scene
