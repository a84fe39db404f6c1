#include "dynamics/contacts/recycling.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "debug/check.hpp"
#include "dynamics/bodies/body_lanes.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

namespace {

struct LaneVector {
    Lanes x, y;
};

struct PointLanes {
    LaneVector anchor_a, anchor_b;
    Lanes separation, feature;
};

struct ManifoldLanes {
    Lanes point_count;
    LaneVector normal;
    PointLanes points[2];
};

// The poses of a reference, and the displacement up to which its manifold may be recycled.
struct ReferenceLanes {
    LaneTurn rotation_a, rotation_b;
    Lanes reach_a, reach_b;
    Lanes tolerance, corners;
};

// How two bodies have moved since the reference. The poses are those of the bodies' origins.
struct MotionSince {
    LaneTurn turn_a, turn_b;
    LaneVector offset;  // of the reference
    LaneVector shift;   // of B's origin relative to A's, world axes, m
};

// The contacts of eight lanes and the frames of their bodies. Lanes beyond the last contact repeat the first one.
struct Sources {
    Contact* contact[kLaneCount];
    const BodyFrame* a[kLaneCount];
    const BodyFrame* b[kLaneCount];
};

Sources find_sources(std::span<Contact* const> contacts, const BodyStore& bodies) {
    Sources sources;
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        Contact* const contact = contacts[lane < contacts.size() ? lane : 0];
        sources.contact[lane] = contact;
        sources.a[lane] = &bodies.frames[contact->body_a];
        sources.b[lane] = &bodies.frames[contact->body_b];
    }
    return sources;
}

TUMBLE_LANE_FUNCTION ReferenceLanes gather_references(const Sources& sources) {
    constexpr std::size_t kFirst = offsetof(Contact, reference) + offsetof(ManifoldReference, rotation_a);
    static_assert(offsetof(ManifoldReference, corners) == offsetof(ManifoldReference, rotation_a) + 28);
    Lanes fields[8];
    gather_members(sources.contact, kFirst, fields);
    return {{fields[0], fields[1]}, {fields[2], fields[3]}, fields[4], fields[5], fields[6], fields[7]};
}

TUMBLE_LANE_FUNCTION ManifoldLanes gather_manifolds(const Sources& sources) {
    constexpr std::size_t kFirst = offsetof(Contact, reference) + offsetof(ManifoldReference, manifold);
    static_assert(offsetof(ManifoldReference, manifold) + 16 * sizeof(float) <= sizeof(ManifoldReference));
    static_assert(offsetof(Manifold, normal) == 4 && offsetof(Manifold, points) == 12 && sizeof(ManifoldPoint) == 24);
    Lanes first[8], second[8];
    gather_members(sources.contact, kFirst, first);
    gather_members(sources.contact, kFirst + 8 * sizeof(float), second);
    return {from_integers(first[0]),
            {first[1], first[2]},
            {{{first[3], first[4]}, {first[5], first[6]}, first[7], second[0]},
             {{second[1], second[2]}, {second[3], second[4]}, second[5], second[6]}}};
}

TUMBLE_LANE_FUNCTION LaneTurn gather_rotations(const BodyFrame* const (&frames)[kLaneCount]) {
    static_assert(offsetof(BodyFrame, pose) == 0 && offsetof(Pose, rotation) == 4 * sizeof(float));
    Lanes pose[8];
    gather_members(frames, 0, pose);
    return {pose[4], pose[5]};
}

TUMBLE_LANE_FUNCTION MotionSince motion_since(const ReferenceLanes& reference, const Sources& sources) {
    MotionSince motion;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const DVec2 offset = sources.contact[lane]->reference.offset;
        const Vec2 shift = to_float(sources.b[lane]->pose.position - sources.a[lane]->pose.position - offset);
        motion.offset.x[lane] = static_cast<float>(offset.x);
        motion.offset.y[lane] = static_cast<float>(offset.y);
        motion.shift.x[lane] = shift.x;
        motion.shift.y[lane] = shift.y;
    }
    motion.turn_a = rotation_between(reference.rotation_a, gather_rotations(sources.a));
    motion.turn_b = rotation_between(reference.rotation_b, gather_rotations(sources.b));
    return motion;
}

// (R(q) - 1) v without cancellation.
TUMBLE_LANE_FUNCTION LaneVector displacement(const LaneTurn& q, const LaneVector& v) {
    const Lanes c = q.c - 1.0f;
    return {c * v.x - q.s * v.y, q.s * v.x + c * v.y};
}

TUMBLE_LANE_FUNCTION Lanes greatest_displacement(const ReferenceLanes& reference, const MotionSince& motion) {
    // In the frame of the body that reaches farther, the other's origin has moved by `relative`, and its points by the
    // relative rotation t: along a chord 2 sin(t / 2) = sin(t) f, f = sqrt(2 / (1 + cos t)), which is convex in cos t,
    // so that it stays below its chord from 1 at cos t = 1 to sqrt(2) at 0.
    const Lanes &reach_a = reference.reach_a, &reach_b = reference.reach_b;
    const LaneTurn frame{select_less(reach_a, reach_b, motion.turn_b.c, motion.turn_a.c),
                         select_less(reach_a, reach_b, motion.turn_b.s, motion.turn_a.s)};
    const LaneVector carried = displacement(frame, motion.offset);
    const LaneVector relative{motion.shift.x - carried.x, motion.shift.y - carried.y};
    const LaneTurn turn = rotation_between(motion.turn_a, motion.turn_b);
    const Lanes chord = turn.s.abs() * (1.0f + 0.41422f * (1.0f - turn.c));
    const Lanes length = square_root(relative.x * relative.x + relative.y * relative.y);
    const Lanes moved = length + chord * smaller(reach_a, reach_b);
    return select_less(Lanes::Zero(), turn.c, moved, Lanes::Constant(std::numeric_limits<float>::infinity()));
}

// Moves the points with the bodies. A sharp corner that touches an edge takes its point along, on both bodies, so that
// the bodies push each other at one point; other points move with each of the bodies. Absent points stay as they are.
TUMBLE_LANE_FUNCTION void move(ManifoldLanes& manifold, const MotionSince& motion, const Lanes& corners) {
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const auto is_above = [&](const Lanes& value, float least) {
        return select_less(Lanes::Constant(least), value, one, zero);
    };
    // The parts of ManifoldReference::corners, 1 or 0.
    const Lanes is_sharp = is_above(corners, -0.5f), is_edge_of_b = is_above(corners, 3.5f);
    const Lanes ends = corners - 4.0f * is_edge_of_b;
    const Lanes second_is_end = is_above(ends, 1.5f), first_is_end = is_above(ends - 2.0f * second_is_end, 0.5f);
    const LaneVector from = manifold.normal;
    const LaneTurn turn{select_less(zero, is_edge_of_b, motion.turn_b.c, motion.turn_a.c),
                        select_less(zero, is_edge_of_b, motion.turn_b.s, motion.turn_a.s)};
    const LaneVector normal{turn.c * from.x - turn.s * from.y, turn.s * from.x + turn.c * from.y};
    manifold.normal = {select_less(zero, manifold.point_count, normal.x, from.x),
                       select_less(zero, manifold.point_count, normal.y, from.y)};
    for (int i = 0; i < 2; ++i) {
        PointLanes& point = manifold.points[i];
        const Lanes follows_a = is_sharp * (is_edge_of_b - (i == 0 ? first_is_end : second_is_end)).abs();
        const Lanes follows_b = is_sharp - follows_a;
        const LaneVector change_a = displacement(motion.turn_a, point.anchor_a);
        const LaneVector change_b = displacement(motion.turn_b, point.anchor_b);
        const Lanes parted_x = motion.shift.x + (change_b.x - change_a.x);
        const Lanes parted_y = motion.shift.y + (change_b.y - change_a.y);
        const Lanes opened = parted_x * normal.x + parted_y * normal.y;
        const Lanes half = 0.5f * opened * (follows_b - follows_a);  // the point stays half way between the surfaces
        const Lanes index = Lanes::Constant(static_cast<float>(i));
        const auto add = [&](Lanes& value, const Lanes& change) {
            value = select_less(index, manifold.point_count, value + change, value);
        };
        add(point.anchor_a.x, change_a.x + (follows_b * parted_x - half * normal.x));
        add(point.anchor_a.y, change_a.y + (follows_b * parted_y - half * normal.y));
        add(point.anchor_b.x, change_b.x - (follows_a * parted_x + half * normal.x));
        add(point.anchor_b.y, change_b.y - (follows_a * parted_y + half * normal.y));
        add(point.separation, opened);
    }
}

// Into the manifolds of the lanes whose bit is set.
TUMBLE_LANE_FUNCTION void scatter_manifolds(const ManifoldLanes& moved, const Sources& sources, unsigned lanes) {
    float unused[8];
    float* first[kLaneCount];
    float* second[kLaneCount];
    float* third[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const bool is_used = lanes >> lane & 1;
        Manifold& manifold = sources.contact[lane]->manifold;
        first[lane] = is_used ? &manifold.normal.x : unused;
        second[lane] = first[lane] + 4;
        third[lane] = is_used ? &manifold.points[1].anchor_a.x : unused;
        if (!is_used) continue;
        const Manifold& from = sources.contact[lane]->reference.manifold;
        TUMBLE_CHECK(from.point_count >= 0);
        TUMBLE_CHECK(from.point_count <= 2);
        manifold.point_count = from.point_count;
        manifold.points[1].separation = moved.points[1].separation[lane];
        manifold.points[1].feature = from.points[1].feature;
    }
    const PointLanes &point = moved.points[0], &other = moved.points[1];
    scatter_rows(moved.normal.x, moved.normal.y, point.anchor_a.x, point.anchor_a.y, first);
    scatter_rows(point.anchor_b.x, point.anchor_b.y, point.separation, point.feature, second);
    scatter_rows(other.anchor_a.x, other.anchor_a.y, other.anchor_b.x, other.anchor_b.y, third);
}

}  // namespace

float recycling_tolerance(const Contact& contact, float smaller_extent) {
    const float least = std::max(kRecyclingPart * contact.speculative_distance, contact.reference.gap);
    if (contact.reference.corners < 0.0f) return least;
    return std::max(least, std::min(kSharpRecyclingPart * contact.speculative_distance,
                                    kSharpRecyclingExtentPart * smaller_extent));
}

TUMBLE_LANE_KERNEL Recycling recycle(std::span<Contact* const> contacts, const BodyStore& bodies) {
    TUMBLE_CHECK(!contacts.empty());
    TUMBLE_CHECK(contacts.size() <= std::size_t{kLaneCount});
    const Sources sources = find_sources(contacts, bodies);
    const ReferenceLanes reference = gather_references(sources);
    const MotionSince motion = motion_since(reference, sources);
    const Lanes moved = greatest_displacement(reference, motion);
    Recycling result;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        result.moved[lane] = moved[lane];
        result.recycled |= static_cast<unsigned>(moved[lane] <= reference.tolerance[lane]) << lane;
    }
    result.recycled &= (1u << contacts.size()) - 1u;
    if (result.recycled == 0) return result;
    ManifoldLanes manifolds = gather_manifolds(sources);
    move(manifolds, motion, reference.corners);
    scatter_manifolds(manifolds, sources, result.recycled);
    return result;
}

}  // namespace tumble
