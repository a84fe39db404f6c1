#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "scene/claims/claims.hpp"
#include "scene/expressions/contact_state.hpp"
#include "scene/model/body_lookup.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/frame.hpp"
#include "scene/model/names.hpp"

namespace tumble::scene {

namespace {

constexpr double kAbsent = std::numeric_limits<double>::infinity();  // excess of a claim on a body that does not exist

double excess_of(double value, const SceneInterval& allowed) {
    if (std::isnan(value)) return kAbsent;
    return std::max({0.0, allowed.lower - value, value - allowed.upper});
}

bool holds(const SceneBox& box, DVec2 p) {
    return p.x >= box.first.x && p.x <= box.second.x && p.y >= box.first.y && p.y <= box.second.y;
}

// How far a point is from the inside of a box, or from its outside (m).
double distance_to_inside(const SceneBox& box, DVec2 p) {
    return length(DVec2{excess_of(p.x, {box.first.x, box.second.x}), excess_of(p.y, {box.first.y, box.second.y})});
}
double distance_to_outside(const SceneBox& box, DVec2 p) {
    if (!holds(box, p)) return 0.0;
    const double least = std::min({p.x - box.first.x, box.second.x - p.x, p.y - box.first.y, box.second.y - p.y});
    return std::max(least, std::numeric_limits<double>::min());
}

Pose frame_of(const SceneExpectation& claim) { return make_frame(claim.frame.value_or(SceneFrame{})); }

// A claim on the state of a body, or of every copy: the copy with the largest excess decides.
class OfBody : public Claim {
public:
    OfBody(const SceneExpectation& claim, bool of_copies)
        : bodies_(claim.body, of_copies),
          of_copies_(of_copies),
          frame_(frame_of(claim)),
          may_be_absent_(of_copies && claim.when == SceneMoment::always && !claim.at) {}

    void follow(const SceneWorld& built) override { bodies_.update(built); }

    // A claim that must always hold for all copies is evaluated while at least one copy exists.
    bool applies() const override { return !may_be_absent_ || !bodies_.members().empty(); }

    double excess(const SceneWorld& built) override {
        double worst = kAbsent;
        state_.reset();
        for (const SceneInstance& body : bodies_.members()) {
            BodyState state = built.world.state(body.id);
            state.pose = seen_from(frame_, state.pose);
            const double excess = excess_of_state(state);
            if (state_ && excess <= worst) continue;
            worst = excess;
            state_ = state;
            name_ = body.name;
        }
        return worst;
    }
    std::string finding(const SceneWorld&) const override {
        if (!state_) return of_copies_ ? "no copy exists" : "it does not exist";
        return (of_copies_ ? "'" + name_ + "': " : "") + seen(*state_);
    }

private:
    virtual double excess_of_state(const BodyState& state) const = 0;
    virtual std::string seen(const BodyState& state) const = 0;

    BodyGroup bodies_;
    bool of_copies_;
    Pose frame_;
    bool may_be_absent_;
    std::string name_;                // of the body that decides
    std::optional<BodyState> state_;  // of that body, in the frame
};

class BodyPosition final : public OfBody {
public:
    BodyPosition(const SceneExpectation& claim, bool of_copies, const SceneBox& box, bool inside)
        : OfBody(claim, of_copies), box_(box), inside_(inside) {}

private:
    double excess_of_state(const BodyState& state) const override {
        const DVec2 position = state.pose.position;
        return inside_ ? distance_to_inside(box_, position) : distance_to_outside(box_, position);
    }
    std::string seen(const BodyState& state) const override { return "it is at " + brief(state.pose.position); }

    SceneBox box_;
    bool inside_;
};

// A claim that a number of a body's state lies between two bounds.
class Measure final : public OfBody {
public:
    Measure(const SceneExpectation& claim, bool of_copies, const SceneInterval& allowed,
            double (*measure)(const BodyState&), const char* before, const char* unit)
        : OfBody(claim, of_copies), allowed_(allowed), measure_(measure), before_(before), unit_(unit) {}

private:
    double excess_of_state(const BodyState& state) const override { return excess_of(measure_(state), allowed_); }
    std::string seen(const BodyState& state) const override {
        return before_ + (" " + brief(measure_(state))) + " " + unit_;
    }

    SceneInterval allowed_;
    double (*measure_)(const BodyState&);
    const char* before_;
    const char* unit_;
};

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

    // Bodies whose contact begins and ends within a step have touched in it.
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

// Whether an instance is the body of that name or one of its copies. An empty name stands for all bodies.
bool is_one_of(const std::string& name, const SceneInstance& body) {
    return name.empty() || body.name == name || base_name(body.name) == name;
}

class Count final : public Claim {
public:
    explicit Count(const SceneExpectation& claim)
        : of_(claim.body), frame_(frame_of(claim)), region_(claim.region.value()), allowed_(claim.count.value()) {}

    double excess(const SceneWorld& built) override {
        count_ = 0;
        for (const SceneInstance& body : built.bodies)
            if (built.world.is_valid(body.id) && is_one_of(of_, body) &&
                built.world.type(body.id) != BodyType::static_body)
                count_ += holds(region_, inverse_transform_point(frame_, built.world.state(body.id).pose.position));
        return excess_of(count_, allowed_);
    }
    std::string finding(const SceneWorld&) const override { return "there are " + std::to_string(count_); }

private:
    std::string of_;
    Pose frame_;
    SceneBox region_;
    SceneInterval allowed_;
    int count_ = 0;
};

class EventCount final : public Claim {
public:
    EventCount(SceneEventKind kind, const std::string& of, const SceneInterval& allowed)
        : kind_(kind), of_(of), allowed_(allowed) {}

    void follow(const SceneWorld& built) override {
        if (built.world.step_count() > 0)
            count_ += count_in_step(built);
        else
            find_joints(built);
    }
    double excess(const SceneWorld&) override { return excess_of(static_cast<double>(count_), allowed_); }
    std::string finding(const SceneWorld&) const override { return "there were " + std::to_string(count_); }
    std::vector<std::uint64_t> state() const override {
        std::vector<std::uint64_t> numbers{count_};
        numbers.insert(numbers.end(), joints_.begin(), joints_.end());
        return numbers;
    }
    bool set_state(std::span<const std::uint64_t> state) override {
        if (state.empty()) return false;
        count_ = state.front();
        joints_.clear();
        for (const std::uint64_t joint : state.subspan(1)) joints_.insert(static_cast<std::uint32_t>(joint));
        return true;
    }

private:
    std::uint64_t count_in_step(const SceneWorld& built) const {
        const StepEvents& events = built.world.events();
        switch (kind_) {
            case SceneEventKind::contact_begin:
                return count(events.contact_begins, built, &ContactBegin::shape_a, &ContactBegin::shape_b);
            case SceneEventKind::contact_end:
                return count(events.contact_ends, built, &ContactEnd::shape_a, &ContactEnd::shape_b);
            case SceneEventKind::contact_hit:
                return count(events.contact_hits, built, &ContactHit::shape_a, &ContactHit::shape_b);
            case SceneEventKind::sensor_begin:
                return count(events.sensor_begins, built, &SensorEvent::sensor, &SensorEvent::visitor);
            case SceneEventKind::sensor_end:
                return count(events.sensor_ends, built, &SensorEvent::sensor, &SensorEvent::visitor);
            case SceneEventKind::joint_broke:
                return static_cast<std::uint64_t>(std::ranges::count_if(
                    events.broken_joints, [&](JointId id) { return of_.empty() || joints_.contains(id.index); }));
            case SceneEventKind::fell_asleep: break;
        }
        return static_cast<std::uint64_t>(
            std::ranges::count_if(events.fell_asleep, [&](BodyId id) { return is_ours(built, id); }));
    }

    template <class Event>
    std::uint64_t count(const std::vector<Event>& events, const SceneWorld& built, ShapeId Event::*a,
                        ShapeId Event::*b) const {
        const auto is_of = [&](ShapeId shape) {
            return built.world.is_valid(shape) && is_ours(built, built.world.body(shape));
        };
        return static_cast<std::uint64_t>(std::ranges::count_if(
            events, [&](const Event& event) { return of_.empty() || is_of(event.*a) || is_of(event.*b); }));
    }

    // The joints of the bodies before the run: the ids of broken ones are stale. A run creates no joints.
    void find_joints(const SceneWorld& built) {
        for (const SceneInstance& body : built.bodies)
            if (!of_.empty() && is_one_of(of_, body))
                for (const JointId joint : built.world.joints(body.id)) joints_.insert(joint.index);
    }

    bool is_ours(const SceneWorld& built, BodyId id) const {
        if (of_.empty()) return true;
        const auto found = std::ranges::find(built.bodies, id, &SceneInstance::id);
        return found != built.bodies.end() && is_one_of(of_, *found);
    }

    SceneEventKind kind_;
    std::string of_;
    SceneInterval allowed_;
    std::set<std::uint32_t> joints_;  // indices
    std::uint64_t count_ = 0;
};

double height_of(const BodyState& state) { return state.pose.position.y; }
double speed_of(const BodyState& state) { return double{length(state.velocity)}; }
double degrees_of(const BodyState& state) { return angle(state.pose.rotation) * kDegrees; }

}  // namespace

std::unique_ptr<Claim> make_claim_of_bodies(const SceneExpectation& claim, const BodyNames& names) {
    const bool of_copies = names.is_shared(claim.body);
    const auto group = [&](const std::string& name) { return BodyGroup(name, names.is_shared(name)); };
    if (claim.inside) return std::make_unique<BodyPosition>(claim, of_copies, *claim.inside, true);
    if (claim.outside) return std::make_unique<BodyPosition>(claim, of_copies, *claim.outside, false);
    if (claim.height)
        return std::make_unique<Measure>(claim, of_copies, *claim.height, height_of, "its height is", "m");
    if (claim.speed) return std::make_unique<Measure>(claim, of_copies, *claim.speed, speed_of, "its speed is", "m/s");
    if (claim.angle)
        return std::make_unique<Measure>(claim, of_copies, *claim.angle, degrees_of, "its angle is", "degrees");
    if (!claim.touches.empty()) return std::make_unique<Touching>(group(claim.body), group(claim.touches), true);
    if (!claim.never_touches.empty())
        return std::make_unique<Touching>(group(claim.body), group(claim.never_touches), false);
    if (claim.count) return std::make_unique<Count>(claim);
    return std::make_unique<EventCount>(claim.event.value(), claim.body, *claim.event_count);
}

}  // namespace tumble::scene
