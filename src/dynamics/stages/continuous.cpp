#include "dynamics/stages/continuous.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/final_poses.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/stages/impact.hpp"
#include "dynamics/stages/swept_bodies.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

class ImpactFinder {
public:
    explicit ImpactFinder(Simulation& simulation) : simulation_(simulation), movers_(simulation.scratch.movers) {}

    void run() {
        find_movers();
        if (movers_.empty()) return;
        for (Mover& mover : movers_) stop_at_immovable(mover);
        for (std::size_t i = 0; i < movers_.size(); ++i)
            if (movers_[i].is_bullet) find_next(i);
        while (stop_first_bullet()) {
        }
        for (const Mover& mover : movers_)
            if (mover.fraction < 1.0) stop(mover);
        std::vector<ProxyPair>& impacts = simulation_.scratch.impacts;
        std::sort(impacts.begin(), impacts.end());
        impacts.erase(std::unique(impacts.begin(), impacts.end()), impacts.end());
    }

private:
    void find_movers() {
        movers_.clear();
        const BodyStore& bodies = simulation_.bodies;
        for (std::size_t i = 1; i < bodies.moving.size(); ++i) {
            const SolverBody& body = bodies.solver_bodies[i];
            if (!(body.flags & kDynamicBody)) continue;
            const BodyMotion& motion = bodies.moving[i].motion;
            const float displacement = length(body.delta_position) + std::abs(body.delta_rotation.s) * motion.reach;
            if (displacement <= kContinuousPart * motion.smallest_extent) continue;
            const std::uint32_t index = bodies.moving[i].body;
            Mover mover;
            mover.body = index;
            mover.sweep = sweep_of(bodies, index);
            mover.is_bullet = (body.flags & kBulletBody) != 0;
            for (const ShapeId shape : bodies.records[index].shapes)
                mover.box = merge(mover.box, box_of_sweep(simulation_.shapes[shape.index].shape, mover.sweep));
            movers_.push_back(mover);
        }
        std::sort(movers_.begin(), movers_.end(), [](const Mover& a, const Mover& b) { return a.body < b.body; });
    }

    // Calls visit(own shape, other shape) for each pair that may touch, of a mover's shape and a shape of these layers
    // near its path. Pairs with a sensor become candidates for a crossing; a mover's own sensor is paired with shapes
    // of all layers.
    template <class Visitor>
    void for_each_near(const Mover& mover, ProxyLayer first, ProxyLayer last, Visitor&& visit) {
        for (const ShapeId own : simulation_.bodies.records[mover.body].shapes) {
            const ShapeRecord& shape = simulation_.shapes[own.index];
            const Aabb box = box_of_sweep(shape.shape, mover.sweep);
            const ProxyLayer top = shape.is_sensor ? ProxyLayer::dynamic : last;
            near_.clear();
            simulation_.broad.query(
                box, [&](std::uint32_t other) { near_.push_back(other); }, first, top);
            for (const std::uint32_t other : near_) {
                const ProxyPair pair = make_pair_of(own.index, other);
                if (may_touch(simulation_, pair))
                    visit(own.index, other);
                else if (shape.is_sensor != simulation_.shapes[other].is_sensor)
                    simulation_.scratch.sensor_crossings.push_back(pair);
            }
        }
    }

    void stop_at_immovable(Mover& mover) {
        for_each_near(mover, ProxyLayer::fixed, ProxyLayer::kinematic, [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            const double fraction = impact(simulation_.shapes[own], mover.sweep, simulation_.shapes[other],
                                           sweep_of(simulation_.bodies, body), was_pushed(own, other));
            const ProxyPair pair = make_pair_of(own, other);
            if (fraction >= mover.fraction || crosses_chain(simulation_.chain_contacts(), pair)) return;
            TUMBLE_CHECK(!(fraction < 0.0));
            mover.fraction = fraction;
            mover.impact = pair;
        });
    }

    // The first impact of a bullet on a dynamic body before it stops.
    void find_next(std::size_t bullet) {
        TUMBLE_CHECK(bullet < movers_.size());
        Mover& mover = movers_[bullet];
        mover.next = mover.fraction;
        mover.partner = kNone;
        for_each_near(mover, ProxyLayer::dynamic, ProxyLayer::dynamic, [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            if (find_mover(body) != kNone) return;
            add_impact(mover, own, other, sweep_of(simulation_.bodies, body), 1.0, kNone);
        });
        // Other movers may come from outside the box of the bullet's sweep.
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            if (i == bullet || !overlaps(mover.box, movers_[i].box)) continue;
            for (const ShapeId own : simulation_.bodies.records[mover.body].shapes)
                for (const ShapeId other : simulation_.bodies.records[movers_[i].body].shapes)
                    if (may_touch(simulation_, make_pair_of(own.index, other.index)))
                        add_impact(mover, own.index, other.index, movers_[i].sweep, movers_[i].fraction, i);
        }
    }

    // Takes the impact of two shapes as the bullet's next one if it is earlier. The other body follows its sweep up to
    // `other_fraction` and rests from then on.
    void add_impact(Mover& mover, std::uint32_t own, std::uint32_t other, const Sweep& other_sweep,
                    double other_fraction, std::size_t partner) {
        const ShapeRecord& shape = simulation_.shapes[own];
        const ShapeRecord& other_shape = simulation_.shapes[other];
        const double both = std::min(mover.next, other_fraction);
        const bool pushed = was_pushed(own, other);
        const double together =
            impact(shape, part_of(mover.sweep, 0.0, both), other_shape, part_of(other_sweep, 0.0, both), pushed);
        double fraction = together * both;
        if (together >= 1.0 && both < mover.next) {
            const double alone = impact(shape, part_of(mover.sweep, both, mover.next), other_shape,
                                        part_of(other_sweep, both, both), pushed);
            fraction = both + alone * (mover.next - both);
        }
        if (fraction >= mover.next) return;
        TUMBLE_CHECK(!(fraction < 0.0));
        mover.next = fraction;
        mover.partner = partner;
        mover.next_impact = make_pair_of(own, other);
    }

    // Stops the bullet with the first impact of all, and its partner; finds the next impacts of other bullets nearby
    // again. False if no bullet has an impact ahead.
    bool stop_first_bullet() {
        std::size_t first = kNone;
        for (std::size_t i = 0; i < movers_.size(); ++i)
            if (movers_[i].next < movers_[i].fraction && (first == kNone || movers_[i].next < movers_[first].next))
                first = i;
        if (first == kNone) return false;
        const std::size_t partner = movers_[first].partner;
        TUMBLE_CHECK(movers_[first].is_bullet);
        TUMBLE_CHECK((partner == kNone || partner < movers_.size()));
        TUMBLE_CHECK(partner != first);

        const double fraction = movers_[first].next;
        movers_[first].fraction = fraction;
        movers_[first].impact = movers_[first].next_impact;
        // The partner may have stopped before.
        if (partner != kNone && movers_[partner].fraction > fraction) {
            movers_[partner].fraction = movers_[partner].next = fraction;
            movers_[partner].impact = movers_[first].impact;
        }
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            const bool is_near = overlaps(movers_[i].box, movers_[first].box) ||
                                 (partner != kNone && overlaps(movers_[i].box, movers_[partner].box));
            if (movers_[i].is_bullet && i != first && i != partner && is_near) find_next(i);
        }
        return true;
    }

    // True if the solver pushed the two shapes apart in this step.
    bool was_pushed(std::uint32_t own, std::uint32_t other) const {
        const Contact* const contact = simulation_.contacts.find(make_pair_of(own, other));
        return contact && (contact->applied[0].normal > 0.0f || contact->applied[1].normal > 0.0f);
    }

    std::size_t find_mover(std::uint32_t body) const {
        const auto found = std::lower_bound(movers_.begin(), movers_.end(), body,
                                            [](const Mover& mover, std::uint32_t key) { return mover.body < key; });
        return found != movers_.end() && found->body == body ? static_cast<std::size_t>(found - movers_.begin())
                                                             : kNone;
    }

    void stop(const Mover& mover) {
        TUMBLE_CHECK(mover.fraction < 1.0);
        TUMBLE_CHECK(mover.impact.a < mover.impact.b);
        simulation_.scratch.impacts.push_back(mover.impact);
        shorten_motion(simulation_.bodies, mover.body, mover.fraction, simulation_.settings.gravity,
                       {simulation_.settings.duration, simulation_.settings.substep_duration()});
    }

    static constexpr std::size_t kNone = Mover::kNone;

    Simulation& simulation_;
    std::vector<Mover>& movers_;  // by body index
    std::vector<std::uint32_t>& near_ = simulation_.scratch.near_shapes;
};

}  // namespace

void stop_at_impacts(Simulation& simulation) {
    simulation.scratch.impacts.clear();
    simulation.scratch.ordered_impacts.impacts.clear();
    simulation.scratch.sensor_crossings.clear();
    if (simulation.settings.continuous) ImpactFinder(simulation).run();
}

}  // namespace tumble
