#include <limits>
#include <optional>
#include <utility>

#include "scene/claims/claims.hpp"
#include "scene/expressions/evaluate.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

class Condition final : public Claim {
public:
    explicit Condition(Program program) : program_(std::move(program)) {}

    double excess(const SceneWorld& built) override {
        shortfall_ = shortfall_of(program_, built);
        return holds(program_, built) ? 0.0 : shortfall_;
    }
    double severity() const override { return shortfall_ <= 0.0 ? shortfall_ : 0.0; }
    std::string finding(const SceneWorld& built) const override { return finding_of(program_, built); }

private:
    Program program_;
    double shortfall_ = 0.0;
};

// The first of two conditions must hold in a state before the first one in which the second holds.
class Order final : public Claim {
public:
    Order(Program first, Program second) : first_{std::move(first), {}}, second_{std::move(second), {}} {}

    void follow(const SceneWorld& built) override {
        rate_ = double{built.world.def().steps_per_second};
        for (Side* side : {&first_, &second_})
            if (!side->step && holds(side->program, built)) side->step = built.world.step_count();
    }
    double excess(const SceneWorld&) override {
        return first_.step && (!second_.step || *first_.step < *second_.step) ? 0.0 : 1.0;
    }
    std::string finding(const SceneWorld&) const override { return text(first_) + ", " + text(second_); }

    std::vector<std::uint64_t> state() const override {
        const auto number = [](const Side& side) { return side.step ? *side.step + 1 : 0; };
        return {number(first_), number(second_)};
    }
    bool set_state(std::span<const std::uint64_t> state) override {
        if (state.size() != 2) return false;
        const auto step = [](std::uint64_t number) {
            return number == 0 ? std::nullopt : std::optional<std::uint64_t>(number - 1);
        };
        first_.step = step(state[0]);
        second_.step = step(state[1]);
        return true;
    }

private:
    struct Side {
        Program program;
        std::optional<std::uint64_t> step;  // the first in which it held
    };

    std::string text(const Side& side) const {
        if (!side.step) return "'" + side.program.text + "' never holds";
        return "'" + side.program.text + "' holds first at " + brief(static_cast<double>(*side.step) / rate_) + " s";
    }

    Side first_, second_;
    double rate_ = 1.0;  // steps/s
};

}  // namespace

std::unique_ptr<Claim> make_claim_of_conditions(const SceneExpectation& claim, const KnownNames& names) {
    if (claim.that.empty()) return nullptr;
    const SceneFrame frame = claim.frame.value_or(SceneFrame{});
    Program that = compile_condition(claim.that, &names, frame);
    if (claim.before.empty()) return std::make_unique<Condition>(std::move(that));
    return std::make_unique<Order>(std::move(that), compile_condition(claim.before, &names, frame));
}

}  // namespace tumble::scene
