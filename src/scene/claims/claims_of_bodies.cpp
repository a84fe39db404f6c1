#include <algorithm>
#include <limits>
#include <optional>

#include "scene/claims/allowed_values.hpp"
#include "scene/claims/claims.hpp"
#include "scene/model/body_lookup.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/frame.hpp"
#include "scene/model/names.hpp"

namespace tumble::scene {

namespace {

// How far a point is from the inside of a box, or from its outside (m).
double distance_to_inside(const SceneBox& box, DVec2 p) {
    return length(DVec2{excess_of(p.x, {box.first.x, box.second.x}), excess_of(p.y, {box.first.y, box.second.y})});
}
double distance_to_outside(const SceneBox& box, DVec2 p) {
    if (!contains(box, p)) return 0.0;
    const double least = std::min({p.x - box.first.x, box.second.x - p.x, p.y - box.first.y, box.second.y - p.y});
    return std::max(least, std::numeric_limits<double>::min());
}

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

double height_of(const BodyState& state) { return state.pose.position.y; }
double speed_of(const BodyState& state) { return double{length(state.velocity)}; }
double degrees_of(const BodyState& state) { return angle(state.pose.rotation) * kDegrees; }

}  // namespace

std::unique_ptr<Claim> make_claim_of_bodies(const SceneExpectation& claim, const BodyNames& names) {
    const bool of_copies = names.is_shared(claim.body);
    if (claim.inside) return std::make_unique<BodyPosition>(claim, of_copies, *claim.inside, true);
    if (claim.outside) return std::make_unique<BodyPosition>(claim, of_copies, *claim.outside, false);
    if (claim.height)
        return std::make_unique<Measure>(claim, of_copies, *claim.height, height_of, "its height is", "m");
    if (claim.speed) return std::make_unique<Measure>(claim, of_copies, *claim.speed, speed_of, "its speed is", "m/s");
    return std::make_unique<Measure>(claim, of_copies, claim.angle.value(), degrees_of, "its angle is", "degrees");
}

}  // namespace tumble::scene
