// From contacts to blocks and back: transposes eight contacts and their bodies into lanes, and the impulses of the
// lanes into contacts.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "debug/check.hpp"
#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/contacts/contact_block.hpp"
#include "simd/transpose.hpp"

namespace tumble {

namespace {

// What the lanes of a block refer to. Unused lanes have a contact without points, between bodies that never move.
struct LaneSources {
    const Contact* contact[kLaneCount];
    const BodyFrame* a[kLaneCount];
    const BodyFrame* b[kLaneCount];
};

LaneSources find_sources(std::span<const std::uint32_t, kLaneCount> lanes, std::span<const Contact> contacts,
                         const BodyStore& bodies) {
    static const Contact unused;
    static const BodyFrame immovable;
    LaneSources sources;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t index = lanes[static_cast<std::size_t>(lane)];
        const bool is_used = index != ConstraintGraph::kNoContact;
        TUMBLE_CHECK((!is_used || index < contacts.size()));
        TUMBLE_CHECK((!is_used || contacts[index].kind == ContactKind::solid));
        TUMBLE_CHECK((!is_used || contacts[index].manifold.point_count > 0));
        TUMBLE_CHECK((!is_used || contacts[index].manifold.point_count <= 2));
        sources.contact[lane] = is_used ? &contacts[index] : &unused;
        sources.a[lane] = is_used ? &bodies.frames[contacts[index].body_a] : &immovable;
        sources.b[lane] = is_used ? &bodies.frames[contacts[index].body_b] : &immovable;
    }
    return sources;
}

// A bit for the lane if a contact can move the body.
std::uint8_t moved_bit(int lane, const BodyFrame& body) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(body.can_move()) << lane);
}

void fill_bodies(ContactBlock& block, const LaneSources& sources) {
    block.moved_a = block.moved_b = 0;
    block.has_locks = false;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const BodyFrame& a = *sources.a[lane];
        const BodyFrame& b = *sources.b[lane];
        block.body_a[lane] = BodyRow::of(a.solver_body);
        block.body_b[lane] = BodyRow::of(b.solver_body);
        block.moved_a |= moved_bit(lane, a);
        block.moved_b |= moved_bit(lane, b);
        block.has_locks |= a.locks_x || a.locks_y || b.locks_x || b.locks_y;
    }
}

// The centres of mass of the bodies from their origins, world axes, m.
struct CenterOffsets {
    Lanes ax, ay, bx, by;
};

TUMBLE_LANE_FUNCTION CenterOffsets fill_masses(ContactBlock& block, const LaneSources& sources) {
    constexpr std::size_t kSecondHalf = sizeof(BodyFrame) / 2;
    static_assert(offsetof(BodyFrame, center_offset) == kSecondHalf + 8);
    static_assert(offsetof(BodyFrame, inv_mass) == kSecondHalf + 16);
    static_assert(offsetof(BodyFrame, inv_inertia) == kSecondHalf + 20);
    Lanes a[8], b[8];
    gather_members(sources.a, kSecondHalf, a);
    gather_members(sources.b, kSecondHalf, b);
    block.inv_mass_a = a[4];
    block.inv_mass_b = b[4];
    block.inv_inertia_a = a[5];
    block.inv_inertia_b = b[5];
    return {a[2], a[3], b[2], b[3]};
}

// What few contacts have. The others do not load the cache line: it saves an eighth of the time to prepare the contacts
// of bench/many_pyramids.
TUMBLE_LANE_FUNCTION void fill_extras(ContactBlock& block, const LaneSources& sources, BounceBy bounces) {
    block.has_radius = block.has_restitution = block.has_rolling_resistance = block.has_tangent_speed = false;
    bool has_extras = false;
    for (const Contact* const contact : sources.contact) has_extras |= contact->has_extras;
    if (!has_extras) return;
    constexpr std::size_t kFirst = offsetof(Contact, radius_a);
    static_assert(offsetof(Contact, radius_b) == kFirst + 4 && offsetof(Contact, tangent_speed) == kFirst + 16);
    Lanes extras[8];
    gather_members(sources.contact, kFirst, extras);
    const Lanes zero = Lanes::Zero();
    block.has_radius = any_less(zero, extras[0]) || any_less(zero, extras[1]);
    block.has_restitution = bounces == BounceBy::solver && any_less(zero, extras[2]);
    block.has_rolling_resistance = any_less(zero, extras[3]);
    block.has_tangent_speed = any_less(zero, extras[4].abs());
    if (block.has_radius) {
        block.extras->radius_a = extras[0];
        block.extras->radius_b = extras[1];
    }
    if (block.has_restitution) {
        block.extras->restitution = extras[2];
        block.extras->absorbed = block.extras->friction_work = zero;
    }
    if (block.has_rolling_resistance) block.extras->rolling_resistance = extras[3];
    if (block.has_tangent_speed) block.extras->tangent_speed = extras[4];
}

// A point of each contact: `point` has the members of ManifoldPoint, `impulse` those of its PointImpulse.
TUMBLE_LANE_FUNCTION void fill_point(ContactBlock& block, int index, const LaneSources& sources,
                                     const CenterOffsets& centers, const Lanes* point, const Lanes* impulse) {
    const Lanes arm_ax = point[0] - centers.ax, arm_ay = point[1] - centers.ay;
    const Lanes arm_bx = point[2] - centers.bx, arm_by = point[3] - centers.by;
    const Lanes zero = Lanes::Zero();
    Lanes is_present;
    for (int lane = 0; lane < kLaneCount; ++lane)
        is_present[lane] = sources.contact[lane]->manifold.point_count > index ? 1.0f : 0.0f;
    const auto present = [&](const Lanes& value, float otherwise) {
        return select_less(zero, is_present, value, Lanes::Constant(otherwise));
    };
    ContactBlockPoint& to = block.points[index];
    to.along_a = present(arm_ax * block.normal_x + arm_ay * block.normal_y, 0.0f);
    to.across_a = present(arm_ax * block.normal_y - arm_ay * block.normal_x, 0.0f);
    to.along_b = present(arm_bx * block.normal_x + arm_by * block.normal_y, 0.0f);
    to.across_b = present(arm_bx * block.normal_y - arm_by * block.normal_x, 0.0f);
    to.separation = present(point[4], kAbsentGap);
    to.normal_impulse = present(impulse[0], 0.0f);
    to.tangent_impulse = present(impulse[1], 0.0f);
    to.applied_normal = to.applied_tangent = zero;
}

TUMBLE_LANE_FUNCTION void fill_points(ContactBlock& block, const LaneSources& sources, const CenterOffsets& centers) {
    static_assert(offsetof(Manifold, points) == offsetof(Manifold, normal) + 8);
    static_assert(offsetof(ManifoldPoint, separation) == 16);
    static_assert(offsetof(Contact, friction) == offsetof(Contact, manifold) + sizeof(Manifold));
    constexpr std::size_t kNormal = offsetof(Contact, manifold) + offsetof(Manifold, normal);
    constexpr std::size_t kSecond = offsetof(Contact, manifold) + offsetof(Manifold, points) + sizeof(ManifoldPoint);
    Lanes normal_and_first[8], second_and_friction[8], impulses[8];
    gather_members(sources.contact, kNormal, normal_and_first);
    gather_members(sources.contact, kSecond, second_and_friction);
    gather_members(sources.contact, offsetof(Contact, impulses), impulses);
    block.normal_x = normal_and_first[0];
    block.normal_y = normal_and_first[1];
    fill_point(block, 0, sources, centers, normal_and_first + 2, impulses);
    fill_point(block, 1, sources, centers, second_and_friction, impulses + 2);
    block.friction = second_and_friction[6];
    block.overlaps = 0;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const bool overlaps = block.points[0].separation[lane] < 0.0f || block.points[1].separation[lane] < 0.0f;
        block.overlaps |= static_cast<std::uint8_t>(static_cast<unsigned>(overlaps) << lane);
    }
}

// The change of velocity at one arm per unit impulse at another: 1/m_A + 1/m_B + r r'/I_A + r r'/I_B.
Lanes response(const ContactBlock& block, const Lanes& linear, const Lanes& arm_a, const Lanes& other_a,
               const Lanes& arm_b, const Lanes& other_b) {
    const Lanes angular_a = block.inv_inertia_a * arm_a * other_a;
    const Lanes angular_b = block.inv_inertia_b * arm_b * other_b;
    return linear + (angular_a + angular_b);
}

// Two points close together make the matrix of the pair nearly singular. With a slightly smaller coupling they share
// the load, and the determinant is at least 1 - 0.98^2 = 4 % of the product of the diagonal.
constexpr float kMaxCoupling = 0.98f;

TUMBLE_LANE_FUNCTION void set_masses(ContactBlock& block) {
    const Lanes zero = Lanes::Zero(), one = Lanes::Ones();
    const Lanes both = block.inv_mass_a + block.inv_mass_b;
    const Lanes linear_normal = block.has_locks ? block.extras->locked.normal : both;
    const Lanes linear_tangent = block.has_locks ? block.extras->locked.tangent : both;
    const Lanes least_response = block.has_locks ? block.extras->locked.least_response : zero;
    ContactBlockPoint& first = block.points[0];
    ContactBlockPoint& second = block.points[1];
    const Lanes absent = Lanes::Constant(0.5f * kAbsentGap);
    for (ContactBlockPoint* point : {&first, &second}) {
        const Lanes normal =
            response(block, linear_normal, point->across_a, point->across_a, point->across_b, point->across_b);
        const Lanes tangent =
            response(block, linear_tangent, point->along_a, point->along_a, point->along_b, point->along_b);
        // A row that the locks leave without response is not solved.
        if (block.has_locks)
            point->separation = select_less(least_response, normal, point->separation, Lanes::Constant(kAbsentGap));
        point->inverse_mass = select_less(point->separation, absent, normal, one);
        const Lanes tangent_mass = select_less(least_response, tangent, one / tangent, zero);
        point->tangent_mass = select_less(point->separation, absent, tangent_mass, zero);
    }
    const Lanes coupling =
        response(block, linear_normal, first.across_a, second.across_a, first.across_b, second.across_b);
    const Lanes product = first.inverse_mass * second.inverse_mass;
    const Lanes limited = clamp_magnitude(coupling, kMaxCoupling * square_root(product));
    block.coupling = select_less(second.separation, absent, limited, zero);
    if (!block.has_rolling_resistance) return;
    const Lanes inertia = block.inv_inertia_a + block.inv_inertia_b;
    block.extras->rolling_mass = select_less(zero, inertia, one / inertia, zero);
}

// The normal velocities with which points reach separation 0, from those before the step (RESTITUTION.md, step 2).
void set_approaches(ContactBlock& block, const BodyStore& bodies, Vec2 gravity, float h) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t body_a = block.body_a[lane].index(), body_b = block.body_b[lane].index();
        const SolverBody& a = bodies.solver_bodies[body_a];
        const SolverBody& b = bodies.solver_bodies[body_b];
        const Vec2 normal{block.normal_x[lane], block.normal_y[lane]};
        const float linear = dot(b.velocity - a.velocity, normal);
        const Vec2 acceleration = bodies.free_acceleration(body_b, gravity) - bodies.free_acceleration(body_a, gravity);
        const float along = dot(acceleration, normal);
        block.extras->acceleration[lane] = along;
        for (int i = 0; i < 2; ++i) {
            const ContactBlockPoint& point = block.points[i];
            const float now =
                linear + b.angular_velocity * point.across_b[lane] - a.angular_velocity * point.across_a[lane];
            const float middle = now + 0.5f * h * along;
            const float speed_sq = speed_sq_after(middle, -point.separation[lane], along);
            block.extras->approach_speed[i][lane] = std::copysign(std::sqrt(std::max(speed_sq, 0.0f)), middle);
        }
    }
}

// The contacts of a block are far apart in memory, at addresses that the hardware does not predict.
void prefetch(std::span<const Contact> contacts, std::span<const std::uint32_t> block, std::size_t lines) {
    for (const std::uint32_t index : block)
        if (index != ConstraintGraph::kNoContact) prefetch(contacts[index], lines);
}

constexpr std::size_t kLeastPrepared = 16;  // in a chunk: about 3 us of work

// The softness of contacts between moving bodies, and of those with a body that does not move.
struct ContactSoftness {
    Softness moving, immovable;
};

void fill_locked_masses(ContactBlock& block, int lane, const BodyFrame& a, const BodyFrame& b) {
    const Vec2 masses_a = a.inv_masses(), masses_b = b.inv_masses(), both = masses_a + masses_b;
    LockedMasses& locked = block.extras->locked;
    locked.ax[lane] = masses_a.x;
    locked.ay[lane] = masses_a.y;
    locked.bx[lane] = masses_b.x;
    locked.by[lane] = masses_b.y;
    const bool has_lock = a.locks_x || a.locks_y || b.locks_x || b.locks_y;
    const float xx = block.normal_x[lane] * block.normal_x[lane], yy = block.normal_y[lane] * block.normal_y[lane];
    locked.normal[lane] = has_lock ? both.x * xx + both.y * yy : both.x;
    locked.tangent[lane] = has_lock ? both.x * yy + both.y * xx : both.x;
    locked.least_response[lane] = has_lock ? kDeadPoint * (a.inv_mass + b.inv_mass) : 0.0f;
}

TUMBLE_LANE_KERNEL void fill_block(ContactBlock& block, const LaneSources& sources, const ContactSoftness& softness,
                                   BounceBy bounces) {
    fill_bodies(block, sources);
    const CenterOffsets centers = fill_masses(block, sources);
    fill_extras(block, sources, bounces);
    fill_points(block, sources, centers);
    if (block.has_locks)
        for (int lane = 0; lane < kLaneCount; ++lane)
            fill_locked_masses(block, lane, *sources.a[lane], *sources.b[lane]);
    if (block.has_rolling_resistance)
        for (int lane = 0; lane < kLaneCount; ++lane)
            block.extras->rolling_impulse[lane] = sources.contact[lane]->rolling_impulse;
    // Lane 0 is always used, and all lanes are alike: colours separate them.
    const bool is_static = block.inv_mass_a[0] == 0.0f || block.inv_mass_b[0] == 0.0f;
    block.softness = is_static ? softness.immovable : softness.moving;
    set_masses(block);
}

// Only a dynamic body is in one contact of a colour; several threads may have another body.
void mark_pushed(SolverBody& body) {
    if (body.flags & kDynamicBody) body.flags |= kPushedBody;
}

// The impulses of absent points are 0. Nothing is read from the manifold, which is in other cache lines than the
// impulses: it saves a twentieth of the solve.
TUMBLE_LANE_KERNEL void store_block(const ContactBlock& block, std::span<const std::uint32_t, kLaneCount> lanes,
                                    std::span<Contact> contacts, std::span<SolverBody> bodies) {
    static_assert(sizeof(Contact::impulses) == 4 * sizeof(float) && sizeof(Contact::applied) == 4 * sizeof(float));
    const ContactBlockPoint &first = block.points[0], &second = block.points[1];
    float unused[4];
    float* impulse_rows[kLaneCount];
    float* applied_rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t index = lanes[static_cast<std::size_t>(lane)];
        const bool is_used = index != ConstraintGraph::kNoContact;
        TUMBLE_CHECK((!is_used || index < contacts.size()));
        impulse_rows[lane] = is_used ? &contacts[index].impulses[0].normal : unused;
        applied_rows[lane] = is_used ? &contacts[index].applied[0].normal : unused;
        if (!is_used) continue;
        TUMBLE_CHECK(!(first.normal_impulse[lane] < 0.0f));
        TUMBLE_CHECK(!(second.normal_impulse[lane] < 0.0f));
        const bool is_pushed = first.applied_normal[lane] > 0.0f || second.applied_normal[lane] > 0.0f;
        contacts[index].is_touching |= is_pushed;
        if (block.has_rolling_resistance && block.extras->rolling_resistance[lane] > 0.0f)
            contacts[index].rolling_impulse = block.extras->rolling_impulse[lane];
        const bool is_rubbed = first.applied_tangent[lane] != 0.0f || second.applied_tangent[lane] != 0.0f;
        if (!is_pushed && !is_rubbed && !(block.overlaps >> lane & 1)) continue;
        mark_pushed(bodies[block.body_a[lane].index()]);
        mark_pushed(bodies[block.body_b[lane].index()]);
    }
    scatter_rows(first.normal_impulse, first.tangent_impulse, second.normal_impulse, second.tangent_impulse,
                 impulse_rows);
    scatter_rows(first.applied_normal, first.applied_tangent, second.applied_normal, second.applied_tangent,
                 applied_rows);
}

}  // namespace

void prepare_contacts(std::span<const Contact> contacts, const BodyStore& bodies, const ConstraintGraph& graph,
                      const Tuning& tuning, Vec2 gravity, float h, BounceBy bounces, std::vector<ContactBlock>& blocks,
                      std::vector<ContactExtras>& extras, Crew& crew) {
    TUMBLE_CHECK(h > 0.0f);
    blocks.resize(graph.block_count());
    extras.resize(graph.block_count());
    if (blocks.empty()) return;
    const ContactSoftness softness{contact_softness(tuning, h), static_contact_softness(tuning, h)};
    crew.for_each(blocks.size(), kLeastPrepared, [&](std::size_t index) {
        if (index + 1 < blocks.size()) prefetch(contacts, graph.block(index + 1), 2);
        ContactBlock& block = blocks[index];
        block.extras = &extras[index];
        fill_block(block, find_sources(graph.block(index), contacts, bodies), softness, bounces);
        if (block.has_restitution) set_approaches(block, bodies, gravity, h);
    });
}

void store_impulses(const std::vector<ContactBlock>& blocks, const ConstraintGraph& graph,
                    const ConstraintGraph::Region& region, std::span<Contact> contacts, std::span<SolverBody> bodies,
                    Crew& crew) {
    for (const ConstraintGraph::Color& color : graph.colors(region)) {
        const auto store = [&](std::size_t i) {
            const std::size_t index = color.begin + i;
            if (index + 1 < blocks.size()) prefetch(contacts, graph.block(index + 1), 1);
            store_block(blocks[index], graph.block(index), contacts, bodies);
        };
        const std::size_t count = color.end - color.begin;
        if (color.is_independent)
            crew.for_each(count, kLeastPrepared, store);
        else
            for (std::size_t i = 0; i < count; ++i) store(i);
    }
}

}  // namespace tumble
