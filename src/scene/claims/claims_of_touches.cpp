#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "scene/claims/allowed_values.hpp"
#include "scene/claims/claims.hpp"
#include "scene/expressions/contact_state.hpp"
#include "scene/model/body_lookup.hpp"
#include "scene/model/display.hpp"
#include "scene/model/names.hpp"

namespace tumble::scene {

namespace {

// A claim that two bodies, or any of their copies, touch or never touch, by the events of every step.
class Touching final : public Claim {
public:
    Touching(BodyGroup a, BodyGroup b, bool wanted) : a_(std::move(a)), b_(std::move(b)), wanted_(wanted) {}

    void follow(const SceneWorld& built) override {
        a_.update(built);
        b_.update(built);
        const World& world = built.world;
        std::erase_if(touching_, [&](const auto& pair) {
            return !world.is_valid(pair.first.first) || !world.is_valid(pair.first.second);
        });
        touched_in_step_ = false;
        if (world.step_count() == 0) return;
        const auto add = [&](ShapeId one, ShapeId other, int change) {
            if (!world.is_valid(one) || !world.is_valid(other)) return;
            const BodyId p = world.body(one), q = world.body(other);
            if (!(a_.has(p) && b_.has(q)) && !(a_.has(q) && b_.has(p))) return;
            const auto pair = touching_.try_emplace(std::minmax(p, q), 0).first;
            pair->second += change;
            if (change > 0) touched_in_step_ = true, last_pair_ = pair->first;
            if (pair->second <= 0) touching_.erase(pair);
        };
        const StepEvents& events = world.events();
        for (const ContactBegin& event : events.contact_begins) add(event.shape_a, event.shape_b, 1);
        for (const ContactEnd& event : events.contact_ends) add(event.shape_a, event.shape_b, -1);
        for (const SensorEvent& event : events.sensor_begins) add(event.sensor, event.visitor, 1);
        for (const SensorEvent& event : events.sensor_ends) add(event.sensor, event.visitor, -1);
    }

    // If the bodies never touch, the smallest gap decides.
    double excess(const SceneWorld& built) override {
        gap_ = kAbsent;
        if (is_touching() == wanted_) return 0.0;
        if (!wanted_) return 1.0;
        if (a_.members().size() * b_.members().size() <= kMostPairs) measure_gap(built.world);
        return std::max(gap_, std::numeric_limits<double>::min());
    }
    std::string finding(const SceneWorld& built) const override {
        if (is_touching()) return touching_text(built);
        if (a_.members().empty() || b_.members().empty())
            return "'" + (a_.members().empty() ? a_ : b_).name() + "' does not exist";
        return gap_ == kAbsent ? "they do not touch" : "they are " + brief(gap_) + " m apart";
    }

    std::vector<std::uint64_t> state() const override {
        std::vector<std::uint64_t> numbers;
        for (const auto& [pair, count] : touching_)
            numbers.insert(numbers.end(), {pair.first.index, pair.first.generation, pair.second.index,
                                           pair.second.generation, static_cast<std::uint64_t>(count)});
        return numbers;
    }
    bool set_state(std::span<const std::uint64_t> state) override {
        constexpr std::size_t kNumbers = 5;  // of each pair
        const auto id = [](std::span<const std::uint64_t> numbers) {
            return BodyId{static_cast<std::uint32_t>(numbers[0]), static_cast<std::uint32_t>(numbers[1])};
        };
        touching_.clear();
        if (state.size() % kNumbers != 0) return false;
        for (; !state.empty(); state = state.subspan(kNumbers))
            touching_[{id(state), id(state.subspan(2))}] = static_cast<int>(state[4]);
        return true;
    }

private:
    static constexpr std::size_t kMostPairs = 1000;  // whose distance is measured in every step

    void measure_gap(const World& world) {
        for (const SceneInstance& a : a_.members())
            for (const SceneInstance& b : b_.members())
                if (a.id != b.id) gap_ = std::min(gap_, gap_between(world, a.id, b.id));
    }

    // A body that enters and leaves a sensor within a step has touched it.
    bool is_touching() const { return touched_in_step_ || !touching_.empty(); }

    // With the names of the copies, if there are several.
    std::string touching_text(const SceneWorld& built) const {
        const auto& [first, second] = touching_.empty() ? last_pair_ : touching_.begin()->first;
        const bool are_single = a_.members().size() == 1 && b_.members().size() == 1;
        return are_single ? "they touch"
                          : display_name(built, first) + " and " + display_name(built, second) + " touch";
    }

    BodyGroup a_, b_;
    bool wanted_;
    std::map<std::pair<BodyId, BodyId>, int> touching_;  // the number of touching pairs of their shapes
    bool touched_in_step_ = false;                       // a contact or sensor event began in the last step
    std::pair<BodyId, BodyId> last_pair_;                // the bodies of the last such event
    double gap_ = kAbsent;                               // m
};

}  // namespace

std::unique_ptr<Claim> make_claim_of_touches(const SceneExpectation& claim, const BodyNames& names) {
    if (claim.touches.empty() && claim.never_touches.empty()) return nullptr;
    const bool is_wanted = !claim.touches.empty();
    const auto group = [&](const std::string& name) { return BodyGroup(name, names.is_shared(name)); };
    return std::make_unique<Touching>(group(claim.body), group(is_wanted ? claim.touches : claim.never_touches),
                                      is_wanted);
}

}  // namespace tumble::scene
