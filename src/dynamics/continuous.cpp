#include "dynamics/continuous.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/constants.hpp"
#include "dynamics/integrate.hpp"
#include "dynamics/sweeps.hpp"

namespace tumble {

namespace {

// The part of a sweep from one fraction to another; equal ones give a body at rest.
Sweep part_of(const Sweep& sweep, double from, double to) {
    const DVec2 way = sweep.end - sweep.start;
    return {sweep.local_center, sweep.start + from * way, sweep.start + to * way, sweep.start_angle + from * sweep.turn,
            (to - from) * sweep.turn};
}

// Along the longest edge, unit.
Vec2 long_axis(const Shape& shape) {
    Vec2 longest{1.0f, 0.0f};
    float size = 0.0f;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 edge = shape.vertex((i + 1) % shape.vertex_count()) - shape.vertex(i);
        if (length(edge) > size) size = length(edge), longest = (1.0f / size) * edge;
    }
    return longest;
}

// A shape shrunk about its middle to a part of its thickness, and by as much of its length: the tip of a bar is no more to
// pass than its side. 0 leaves the middle point.
Shape core_of(const ShapeRecord& record, float part) {
    const Shape& shape = record.shape;
    const Vec2 middle = mass_properties(shape).center;
    if (part == 0.0f || shape.vertex_count() > Shape::kInlineVertices)
        return make_circle(0.5f * part * record.smaller_extent, middle);
    const Vec2 along = long_axis(shape), across = perp(along);
    Vec2 reach;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        reach = {std::max(reach.x, std::abs(dot(along, arm))), std::max(reach.y, std::abs(dot(across, arm)))};
    }
    const float inset = (1.0f - part) * (0.5f * record.smaller_extent - shape.radius());
    const auto scale = [&](float way) { return way > 0.0f ? std::max(part, 1.0f - inset / way) : part; };
    const float scale_along = scale(reach.x), scale_across = scale(reach.y);
    std::array<Vec2, Shape::kInlineVertices> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const Vec2 arm = shape.vertex(i) - middle;
        vertices[static_cast<std::size_t>(i)] =
            middle + (scale_along * dot(along, arm)) * along + (scale_across * dot(across, arm)) * across;
    }
    return Shape::from_raw({vertices.data(), static_cast<std::size_t>(shape.vertex_count())}, part * shape.radius());
}

// True if a shape that has sunk in deeper than it may would sink in further, up to its middle.
bool sinks_deeper(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep) {
    for (const float part : kContinuousInnerCores) {
        const CastResult core = time_of_impact(other.shape, other_sweep, core_of(moving, part), sweep);
        if (core.status != CastStatus::overlapping) return core.status == CastStatus::hit;
    }
    return false;
}

// When a shape must stop for another: 1 if it may go all the way.
double impact(const ShapeRecord& moving, const Sweep& sweep, const ShapeRecord& other, const Sweep& other_sweep) {
    if (other.link && is_behind(other.shape, *other.link, pose_at(other_sweep, 0.0), moving.shape, pose_at(sweep, 0.0)))
        return 1.0;
    const CastResult core = time_of_impact(other.shape, other_sweep, core_of(moving, kContinuousCore), sweep);
    if (core.status == CastStatus::overlapping) return sinks_deeper(moving, sweep, other, other_sweep) ? 0.0 : 1.0;
    if (core.status != CastStatus::hit) return 1.0;
    const CastResult surface = time_of_impact(other.shape, other_sweep, moving.shape, sweep);
    // Who touched already at the start may sink in as far as its core.
    const bool touched = surface.status != CastStatus::hit || surface.fraction <= 0.0;
    return touched ? core.fraction : surface.fraction;
}

// The box of all that a shape may cover on its way, whatever it turns.
Aabb box_on_way(const Shape& shape, const Sweep& sweep) {
    const Shape disc = make_circle(farthest_distance(shape, sweep.local_center));
    return merge(bounds(disc, {sweep.start, {}}), bounds(disc, {sweep.end, {}}));
}

// The velocity of a body that is taken back by `way`, which it took the time `lost` for, under an acceleration that acted
// all the while. The speed along it is what is due at that height, whatever the body has bounced off in the step: taking
// off what the acceleration has given in that time gains energy if it has.
Vec2 velocity_before(Vec2 velocity, Vec2 way, float lost, Vec2 acceleration, float h) {
    const float size = length(acceleration);
    if (size == 0.0f) return velocity;
    const Vec2 down = (1.0f / size) * acceleration;
    const float middle = dot(velocity, down) + 0.5f * h * size;
    const float before = std::copysign(speed_after(middle, -dot(way, down), size), middle - lost * size);
    return velocity + (before - middle) * down;
}

class ImpactFinder {
public:
    explicit ImpactFinder(Simulation& simulation) : simulation_(simulation), movers_(simulation.movers) {}

    void run() {
        find_movers();
        if (movers_.empty()) return;
        for (Mover& mover : movers_) stop_at_immovable(mover);
        for (std::size_t i = 0; i < movers_.size(); ++i)
            if (movers_[i].is_bullet) find_next(i);
        while (stop_first_bullet()) {
        }
        for (const Mover& mover : movers_)
            if (mover.fraction < 1.0) shorten(mover);
        std::vector<ProxyPair>& impacts = simulation_.impacts;
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
            const float way = length(body.delta_position) + std::abs(body.delta_rotation.s) * motion.reach;
            if (way <= kContinuousPart * motion.smallest_extent) continue;
            const std::uint32_t index = bodies.moving[i].body;
            Mover mover;
            mover.body = index;
            mover.sweep = sweep_of(bodies, index);
            mover.is_bullet = (body.flags & kBulletBody) != 0;
            for (const ShapeId shape : bodies.records[index].shapes)
                mover.box = merge(mover.box, box_on_way(simulation_.shapes[shape.index].shape, mover.sweep));
            movers_.push_back(mover);
        }
        std::sort(movers_.begin(), movers_.end(), [](const Mover& a, const Mover& b) { return a.body < b.body; });
    }

    // Calls visit(own shape, other shape) for each pair that may meet, of a mover and a shape near its way.
    template <class Visitor>
    void for_each_near(const Mover& mover, Visitor&& visit) {
        for (const ShapeId own : simulation_.bodies.records[mover.body].shapes) {
            const Aabb box = box_on_way(simulation_.shapes[own.index].shape, mover.sweep);
            near_.clear();
            simulation_.broad.query(box, [&](std::uint32_t other) { near_.push_back(other); });
            for (const std::uint32_t other : near_) {
                const ProxyPair pair = make_pair_of(own.index, other);
                if (may_touch(simulation_, pair))
                    visit(own.index, other);
                else if (simulation_.shapes[own.index].is_sensor != simulation_.shapes[other].is_sensor)
                    simulation_.sensor_passes.push_back(pair);
            }
        }
    }

    void stop_at_immovable(Mover& mover) {
        for_each_near(mover, [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            if (simulation_.bodies.is_dynamic(body)) return;
            const double fraction = impact(simulation_.shapes[own], mover.sweep, simulation_.shapes[other],
                                           sweep_of(simulation_.bodies, body));
            if (fraction >= mover.fraction) return;
            mover.fraction = fraction;
            mover.meeting = make_pair_of(own, other);
        });
    }

    // The first meeting of a bullet with anything dynamic before it is stopped.
    void find_next(std::size_t bullet) {
        Mover& mover = movers_[bullet];
        mover.next = mover.fraction;
        mover.partner = kNobody;
        for_each_near(mover, [&](std::uint32_t own, std::uint32_t other) {
            const std::uint32_t body = simulation_.shapes[other].body;
            if (!simulation_.bodies.is_dynamic(body) || find_mover(body) != kNobody) return;
            meet(mover, own, other, sweep_of(simulation_.bodies, body), 1.0, kNobody);
        });
        // Other fast bodies may come from outside the box.
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            if (i == bullet || !overlaps(mover.box, movers_[i].box)) continue;
            for (const ShapeId own : simulation_.bodies.records[mover.body].shapes)
                for (const ShapeId other : simulation_.bodies.records[movers_[i].body].shapes)
                    if (may_touch(simulation_, make_pair_of(own.index, other.index)))
                        meet(mover, own.index, other.index, movers_[i].sweep, movers_[i].fraction, i);
        }
    }

    // The other goes along its sweep until it is stopped, and stands from then on.
    void meet(Mover& mover, std::uint32_t own, std::uint32_t other, const Sweep& other_sweep, double other_fraction,
              std::size_t partner) {
        const ShapeRecord& shape = simulation_.shapes[own];
        const ShapeRecord& other_shape = simulation_.shapes[other];
        const double both = std::min(mover.next, other_fraction);
        const double together =
            impact(shape, part_of(mover.sweep, 0.0, both), other_shape, part_of(other_sweep, 0.0, both));
        double fraction = together * both;
        if (together >= 1.0 && both < mover.next) {
            const double alone =
                impact(shape, part_of(mover.sweep, both, mover.next), other_shape, part_of(other_sweep, both, both));
            fraction = both + alone * (mover.next - both);
        }
        if (fraction >= mover.next) return;
        mover.next = fraction;
        mover.partner = partner;
        mover.next_meeting = make_pair_of(own, other);
    }

    // Of all meetings ahead the first one happens; those who may come by are
    // looked at again.
    bool stop_first_bullet() {
        std::size_t first = kNobody;
        for (std::size_t i = 0; i < movers_.size(); ++i)
            if (movers_[i].next < movers_[i].fraction && (first == kNobody || movers_[i].next < movers_[first].next))
                first = i;
        if (first == kNobody) return false;
        const std::size_t partner = movers_[first].partner;
        const double fraction = movers_[first].next;
        movers_[first].fraction = fraction;
        movers_[first].meeting = movers_[first].next_meeting;
        // The partner may stand already.
        if (partner != kNobody && movers_[partner].fraction > fraction) {
            movers_[partner].fraction = movers_[partner].next = fraction;
            movers_[partner].meeting = movers_[first].meeting;
        }
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            const bool concerned = overlaps(movers_[i].box, movers_[first].box) ||
                                   (partner != kNobody && overlaps(movers_[i].box, movers_[partner].box));
            if (movers_[i].is_bullet && i != first && i != partner && concerned) find_next(i);
        }
        return true;
    }

    std::size_t find_mover(std::uint32_t body) const {
        const auto found = std::lower_bound(movers_.begin(), movers_.end(), body,
                                            [](const Mover& mover, std::uint32_t key) { return mover.body < key; });
        return found != movers_.end() && found->body == body ? static_cast<std::size_t>(found - movers_.begin())
                                                             : kNobody;
    }

    // The motion ends at the fraction, and gravity and forces did not act for the rest of the step.
    void shorten(const Mover& mover) {
        simulation_.impacts.push_back(mover.meeting);
        const std::uint32_t index = simulation_.bodies.frames[mover.body].solver_body;
        SolverBody& body = simulation_.bodies.solver_bodies[index];
        const MovingBody& moving = simulation_.bodies.moving[index];
        const DVec2 way = mover.sweep.end - mover.sweep.start;
        const double rest = 1.0 - mover.fraction;
        const float lost = static_cast<float>(rest) * simulation_.settings.duration;
        const Vec2 acceleration = allowed(body.flags, moving.free_acceleration(simulation_.settings.gravity));
        body.velocity = velocity_before(body.velocity, to_float(rest * way), lost, acceleration,
                                        simulation_.settings.substep_duration());
        body.angular_velocity -= allowed(body.flags, lost * moving.angular_acceleration);
        body.delta_position = to_float(mover.fraction * way);
        body.delta_rotation = make_rotation(mover.fraction * mover.sweep.turn);
    }

    static constexpr std::size_t kNobody = Mover::kNobody;

    Simulation& simulation_;
    std::vector<Mover>& movers_;  // by body index
    std::vector<std::uint32_t>& near_ = simulation_.near_shapes;
};

}  // namespace

void stop_at_impacts(Simulation& simulation) {
    simulation.impacts.clear();
    simulation.sensor_passes.clear();
    if (simulation.settings.continuous) ImpactFinder(simulation).run();
}

}  // namespace tumble
