#include "dynamics/continuous/impact_response.hpp"

#include <algorithm>

#include "dynamics/bodies/constants.hpp"
#include "dynamics/continuous/impact_members.hpp"
#include "dynamics/impacts/impact_rows.hpp"

namespace tumble {

namespace {

// An impact goes on through a touching contact if it gives it an approach above the threshold of bounces, and at least
// this part of its own approach speed. Smaller: impacts on piles cost more (in a tumbler of 2000 boxes five times as
// much at 0.1). Larger: elastic bodies that touch several others lose energy.
constexpr double kPassedOn = 0.3;

// Of an impact without a bounce; one with a bounce weighs 1. Larger: bodies of fast piles stop sooner, and sink deeper.
// Smaller: their step costs a hundred times as much.
constexpr int kInelasticWeight = 8;

class ImpactResponse {
public:
    ImpactResponse(Simulation& simulation, const NextImpact& impact)
        : simulation_(simulation),
          scratch_(simulation.scratch->ordered_impacts),
          group_(scratch_.group),
          impact_(impact),
          members_(simulation, impact_),
          duration_(simulation.settings.duration) {}

    void run() {
        members_.begin();
        solve();
        if (!has_changed() && impact_.normal != DVec2{}) {
            members_.begin_at_found_point();
            solve();
        }
        for (std::size_t i = 0; i < scratch_.members.size(); ++i) apply(i);
        store_impulses();
        members_.link_impacts();
    }

private:
    void solve() {
        double fastest = 0.0;
        for (const ImpactPoint& point : group_.points) fastest = std::max(fastest, -approach_at_impact(group_, point));
        do {
            solve_impacts(group_);
        } while (members_.grow(kPassedOn * fastest));
    }

    bool has_changed() const {
        return std::any_of(group_.bodies.begin(), group_.bodies.end(),
                           [](const ImpactBody& body) { return body.change != Twist{} || body.hold != Twist{}; });
    }

    // The impact counts for its two bodies even if they part without an impulse. Other members may have no part in it.
    void apply(std::size_t index) {
        if (scratch_.members[index] == kNotSwept) return;
        if (index >= 2 && group_.bodies[index].change == Twist{} && group_.bodies[index].hold == Twist{}) return;
        SweptBody& swept = scratch_.swept[scratch_.members[index]];
        if (!simulation_.bodies.is_dynamic(swept.body)) return;
        const ImpactBody& body = group_.bodies[index];
        swept.push(body.change, duration_);
        swept.hold(body.hold, duration_);
        ++swept.impact_count;
        swept.impact_weight += weight(index);
        if (swept.impact_weight >= kMaxImpactsPerBody || has_joints(swept.body)) swept.stop();
    }

    // An impact without a bounce weighs more for its two bodies: they only come nearer to rest.
    int weight(std::size_t index) const {
        const bool bounces = !group_.points.empty() && group_.points.front().restitution > 0.0;
        return index >= 2 || bounces ? 1 : kInelasticWeight;
    }

    // Joints do not take part in impacts: a joined body goes on in the next step.
    bool has_joints(std::uint32_t body) const { return !simulation_.bodies.records[body].joints.empty(); }

    // What contacts report: the impulses of impacts count as applied in this step.
    void store_impulses() {
        for (std::size_t i = 0; i < group_.points.size(); ++i) {
            const PointImpulse applied{static_cast<float>(group_.points[i].normal_impulse),
                                       static_cast<float>(group_.points[i].tangent_impulse)};
            const GroupPoint& own = scratch_.group_points[i];
            if (own.impact >= 0)
                scratch_.impacts[static_cast<std::size_t>(own.impact)].applied[own.manifold_point] = applied;
            Contact* const contact = simulation_.contacts.find(own.shapes);
            if (!contact) continue;
            if (own.impact < 0) contact->applied[own.manifold_point] += applied;
            contact->is_touching |= applied.normal > 0.0f;
            contact->is_bouncing = false;
        }
        if (Contact* const contact = simulation_.contacts.find(impact_.shapes)) contact->is_bouncing = false;
    }

    Simulation& simulation_;
    ImpactScratch& scratch_;
    ImpactGroup& group_;
    NextImpact impact_;
    ImpactMembers members_;
    double duration_;  // of the step, s
};

}  // namespace

void respond(Simulation& simulation, const NextImpact& impact) { ImpactResponse(simulation, impact).run(); }

}  // namespace tumble
