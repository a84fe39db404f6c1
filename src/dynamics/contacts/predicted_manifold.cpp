#include "dynamics/contacts/predicted_manifold.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/contacts/collide_posed.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

namespace {

FreeMotion free_motion(const BodyStore& bodies, std::uint32_t body, const StepAhead& step) {
    const std::uint32_t solver_body = bodies.frames[body].solver_body;
    return solver_body < step.motions.size() ? step.motions[solver_body]
                                             : bodies.free_motion(solver_body, step.gravity, step.duration);
}

// How far the points of the two shapes move against each other, at most, m.
float relative_displacement(const PosedShape& a, const FreeMotion& of_a, const PosedShape& b, const FreeMotion& of_b) {
    return length(of_b.path - of_a.path) + std::abs(of_a.turn) * a.record.reach + std::abs(of_b.turn) * b.record.reach;
}

Vec2 turned(Vec2 v, double angle) {
    const SinCos at = sin_cos(angle);
    const DVec2 from(v);
    return to_float(DVec2{at.cos * from.x - at.sin * from.y, at.sin * from.x + at.cos * from.y});
}

// An anchor before a turn: its core turns with the body, but the rounding around the core has no orientation.
// `rounding` is from the core to the surface, m.
Vec2 turned_anchor(Vec2 anchor, Vec2 rounding, double angle) { return turned(anchor - rounding, angle) + rounding; }

// The manifold at a fraction of the two sweeps, with the separations and anchors that its points have at the start.
Manifold manifold_at(Contact& contact, const PosedShape& a, const Sweep& sweep_a, const PosedShape& b,
                     const Sweep& sweep_b, double fraction) {
    const Pose pose_a = pose_at(sweep_a, fraction), pose_b = pose_at(sweep_b, fraction);
    const DVec2 offset = b.world_from_body.position - a.world_from_body.position;
    const DVec2 displacement = pose_b.position - pose_a.position - offset;
    Manifold manifold = collide_posed({a.record, pose_a}, {b.record, pose_b}, contact, contact.speculative_distance,
                                      to_float(displacement));
    for (int i = 0; i < manifold.point_count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        point.anchor_a = turned_anchor(point.anchor_a, contact.radius_a * manifold.normal, -fraction * sweep_a.turn);
        point.anchor_b = turned_anchor(point.anchor_b, -contact.radius_b * manifold.normal, -fraction * sweep_b.turn);
        point.separation += dot(to_float(offset) + (point.anchor_b - point.anchor_a), manifold.normal);
    }
    return manifold;
}

}  // namespace

Manifold predict_manifold(Contact& contact, const PosedShape& a, const PosedShape& b, float gap,
                          const BodyStore& bodies, const StepAhead& step) {
    const FreeMotion of_a = free_motion(bodies, contact.body_a, step), of_b = free_motion(bodies, contact.body_b, step);
    const float moved = relative_displacement(a, of_a, b, of_b);
    if (!(moved > std::max(contact.speculative_distance + std::min(gap, 0.0f), gap))) return {};
    const float reach = contact.speculative_distance + moved;
    if (contact.manifold.point_count > 0) return collide_posed(a, b, contact, reach, of_b.path - of_a.path);
    // Most pairs move in parallel or apart: one distance rules them out.
    const Manifold near =
        collide(a.record.shape, a.world_from_body, b.record.shape, b.world_from_body, reach, contact.cache);
    if (near.point_count == 0) return {};
    const Sweep sweep_a = sweep_of(bodies, contact.body_a, of_a), sweep_b = sweep_of(bodies, contact.body_b, of_b);
    const CastResult impact = time_of_impact(a.record.shape, sweep_a, b.record.shape, sweep_b);
    if (impact.status != CastStatus::hit) return {};
    return manifold_at(contact, a, sweep_a, b, sweep_b, impact.fraction);
}

}  // namespace tumble
