#include <algorithm>
#include <set>
#include <vector>

#include "scene/claims/allowed_values.hpp"
#include "scene/claims/claims.hpp"
#include "scene/model/names.hpp"

namespace tumble::scene {

namespace {

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
                count_ += contains(region_, inverse_transform_point(frame_, built.world.state(body.id).pose.position));
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

}  // namespace

std::unique_ptr<Claim> make_claim_of_counts(const SceneExpectation& claim) {
    if (claim.count) return std::make_unique<Count>(claim);
    if (!claim.event_count) return nullptr;
    return std::make_unique<EventCount>(claim.event.value(), claim.body, *claim.event_count);
}

}  // namespace tumble::scene
