#include "dynamics/continuous/continuous.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/final_poses.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/continuous/swept_bodies.hpp"
#include "dynamics/continuous/swept_pair.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

constexpr std::size_t kLeastBodies = 128, kLeastFast = 4;  // in a chunk: some us of work

class ImpactFinder {
public:
    explicit ImpactFinder(Simulation& simulation) : simulation_(simulation), fast_(simulation.scratch->fast_bodies) {}

    void run() {
        crew_.work_together(simulation_.bodies.moving.size(), [&] {
            find_bodies();
            stop_at_immovable();
        });
        if (fast_.empty()) return;
        for (std::size_t i = 0; i < fast_.size(); ++i)
            if (fast_[i].is_bullet) find_next(i);
        while (stop_first_bullet()) {
        }
        for (const FastBody& fast : fast_)
            if (fast.fraction < 1.0) stop(fast);
        std::vector<ProxyPair>& impacts = simulation_.scratch->impacts;
        std::sort(impacts.begin(), impacts.end());
        impacts.erase(std::unique(impacts.begin(), impacts.end()), impacts.end());
    }

private:
    static bool is_bullet(const SolverBody& body) { return (body.flags & kBulletBody) != 0; }

    void find_bodies() {
        fast_.clear();
        const BodyStore& bodies = simulation_.bodies;
        const bool has_bullets = std::any_of(bodies.solver_bodies.begin(), bodies.solver_bodies.end(), is_bullet);
        const auto add_if_fast = [&](std::size_t i, std::vector<std::uint32_t>& found) {
            const SolverBody& body = bodies.solver_bodies[i];
            if (!(body.flags & kDynamicBody)) return;
            const BodyMotion& motion = bodies.moving[i].motion;
            if (displacement_in_step(body, motion) <= kContinuousPart * motion.smallest_extent) return;
            const std::uint32_t index = bodies.moving[i].body;
            if (has_bullets || may_reach_immovable(simulation_, index)) found.push_back(index);
        };
        ChunkLists<std::uint32_t>& found = simulation_.scratch->chunks.found;
        found.fill(crew_, bodies.moving.size(), kLeastBodies, add_if_fast);
        found.for_each([&](std::uint32_t index) {
            const SolverBody& body = bodies.solver_bodies[bodies.frames[index].solver_body];
            FastBody fast;
            fast.body = index;
            fast.sweep = sweep_of(bodies, index);
            fast.is_bullet = is_bullet(body);
            for (const ShapeId shape : bodies.records[index].shapes)
                fast.box = merge(fast.box, box_of_sweep(simulation_.shapes[shape.index].shape, fast.sweep));
            fast_.push_back(fast);
        });
        std::sort(fast_.begin(), fast_.end(), [](const FastBody& a, const FastBody& b) { return a.body < b.body; });
    }

    // Calls visit(own shape, other shape) for each pair that may touch, of a fast body's shape and a shape of these
    // layers near its path. Adds pairs with a sensor to `crossings`, which may cross; a fast body's own sensor is
    // paired with shapes of all layers.
    template <class Visitor>
    void for_each_near(const FastBody& fast, ProxyLayer first, ProxyLayer last, std::vector<ProxyPair>& crossings,
                       Visitor&& visit) const {
        for (const ShapeId own : simulation_.bodies.records[fast.body].shapes) {
            const ShapeRecord& shape = simulation_.shapes[own.index];
            const Aabb box = box_of_sweep(shape.shape, fast.sweep);
            const ProxyLayer top = shape.is_sensor ? ProxyLayer::dynamic : last;
            const auto add = [&](std::uint32_t other) {
                const ProxyPair pair = make_pair_of(own.index, other);
                if (may_touch(simulation_, pair))
                    visit(own.index, other);
                else if (shape.is_sensor != simulation_.shapes[other].is_sensor)
                    crossings.push_back(pair);
            };
            simulation_.broad.query(box, add, first, top);
        }
    }

    void stop_at_immovable() {
        ChunkLists<ProxyPair>& crossings = simulation_.scratch->chunks.crossings;
        crossings.fill(crew_, fast_.size(), kLeastFast,
                       [&](std::size_t i, std::vector<ProxyPair>& list) { stop_at_immovable(fast_[i], list); });
        crossings.for_each([&](ProxyPair pair) { simulation_.scratch->sensor_crossings.push_back(pair); });
    }

    void stop_at_immovable(FastBody& fast, std::vector<ProxyPair>& crossings) const {
        const auto stop_at = [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            const double fraction = find_stop(simulation_.shapes[own], fast.sweep, simulation_.shapes[other],
                                              sweep_of(simulation_.bodies, body), was_pushed(own, other));
            const ProxyPair pair = make_pair_of(own, other);
            if (fraction >= fast.fraction || crosses_chain(simulation_.chain_contacts(), pair)) return;
            TUMBLE_CHECK(!(fraction < 0.0));
            fast.fraction = fraction;
            fast.impact = pair;
        };
        for_each_near(fast, ProxyLayer::fixed, ProxyLayer::kinematic, crossings, stop_at);
    }

    // The first impact of a bullet on a dynamic body before it stops.
    void find_next(std::size_t bullet) {
        TUMBLE_CHECK(bullet < fast_.size());
        FastBody& fast = fast_[bullet];
        fast.next = fast.fraction;
        fast.partner = kNone;
        const auto add_slow = [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            if (find_index(body) != kNone) return;
            add_impact(fast, own, other, sweep_of(simulation_.bodies, body), 1.0, kNone);
        };
        for_each_near(fast, ProxyLayer::dynamic, ProxyLayer::dynamic, simulation_.scratch->sensor_crossings, add_slow);
        // Other fast bodies may come from outside the box of the bullet's sweep.
        for (std::size_t i = 0; i < fast_.size(); ++i) {
            if (i == bullet || !overlaps(fast.box, fast_[i].box)) continue;
            for (const ShapeId own : simulation_.bodies.records[fast.body].shapes)
                for (const ShapeId other : simulation_.bodies.records[fast_[i].body].shapes)
                    if (may_touch(simulation_, make_pair_of(own.index, other.index)))
                        add_impact(fast, own.index, other.index, fast_[i].sweep, fast_[i].fraction, i);
        }
    }

    // Takes the impact of two shapes as the bullet's next one if it is earlier. The other body follows its sweep up to
    // `other_fraction` and rests from then on.
    void add_impact(FastBody& fast, std::uint32_t own, std::uint32_t other, const Sweep& other_sweep,
                    double other_fraction, std::size_t partner) {
        const ShapeRecord& shape = simulation_.shapes[own];
        const ShapeRecord& other_shape = simulation_.shapes[other];
        const double both = std::min(fast.next, other_fraction);
        const bool pushed = was_pushed(own, other);
        const double together =
            find_stop(shape, part_of(fast.sweep, 0.0, both), other_shape, part_of(other_sweep, 0.0, both), pushed);
        double fraction = together * both;
        if (together >= 1.0 && both < fast.next) {
            const double alone = find_stop(shape, part_of(fast.sweep, both, fast.next), other_shape,
                                           part_of(other_sweep, both, both), pushed);
            fraction = both + alone * (fast.next - both);
        }
        if (fraction >= fast.next) return;
        TUMBLE_CHECK(!(fraction < 0.0));
        fast.next = fraction;
        fast.partner = partner;
        fast.next_impact = make_pair_of(own, other);
    }

    // Stops the bullet with the first impact of all, and its partner; finds the next impacts of other bullets nearby
    // again. False if no bullet has an impact ahead.
    bool stop_first_bullet() {
        std::size_t first = kNone;
        for (std::size_t i = 0; i < fast_.size(); ++i)
            if (fast_[i].next < fast_[i].fraction && (first == kNone || fast_[i].next < fast_[first].next)) first = i;
        if (first == kNone) return false;
        const std::size_t partner = fast_[first].partner;
        TUMBLE_CHECK(fast_[first].is_bullet);
        TUMBLE_CHECK((partner == kNone || partner < fast_.size()));
        TUMBLE_CHECK(partner != first);

        const double fraction = fast_[first].next;
        fast_[first].fraction = fraction;
        fast_[first].impact = fast_[first].next_impact;
        // The partner may have stopped before.
        if (partner != kNone && fast_[partner].fraction > fraction) {
            fast_[partner].fraction = fast_[partner].next = fraction;
            fast_[partner].impact = fast_[first].impact;
        }
        for (std::size_t i = 0; i < fast_.size(); ++i) {
            const bool is_near = overlaps(fast_[i].box, fast_[first].box) ||
                                 (partner != kNone && overlaps(fast_[i].box, fast_[partner].box));
            if (fast_[i].is_bullet && i != first && i != partner && is_near) find_next(i);
        }
        return true;
    }

    // True if the solver pushed the two shapes apart in this step.
    bool was_pushed(std::uint32_t own, std::uint32_t other) const {
        const Contact* const contact = simulation_.contacts.find(make_pair_of(own, other));
        return contact && (contact->applied[0].normal > 0.0f || contact->applied[1].normal > 0.0f);
    }

    std::size_t find_index(std::uint32_t body) const {
        const auto found = std::lower_bound(fast_.begin(), fast_.end(), body,
                                            [](const FastBody& fast, std::uint32_t key) { return fast.body < key; });
        return found != fast_.end() && found->body == body ? static_cast<std::size_t>(found - fast_.begin()) : kNone;
    }

    void stop(const FastBody& fast) {
        TUMBLE_CHECK(fast.fraction < 1.0);
        TUMBLE_CHECK(fast.impact.a < fast.impact.b);
        simulation_.scratch->impacts.push_back(fast.impact);
        shorten_motion(simulation_.bodies, fast.body, fast.fraction, simulation_.settings.gravity,
                       {simulation_.settings.duration, simulation_.settings.substep_duration()});
    }

    static constexpr std::size_t kNone = FastBody::kNone;

    Simulation& simulation_;
    std::vector<FastBody>& fast_;  // by body index
    Crew& crew_ = simulation_.crew;
};

}  // namespace

void stop_at_impacts(Simulation& simulation) {
    simulation.scratch->impacts.clear();
    simulation.scratch->ordered_impacts.impacts.clear();
    simulation.scratch->sensor_crossings.clear();
    if (simulation.settings.continuous) ImpactFinder(simulation).run();
}

}  // namespace tumble
