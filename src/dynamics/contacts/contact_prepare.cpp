// From contacts to blocks and back: fills the lanes one by one, and reads the impulses from them.
#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/bodies/ballistics.hpp"
#include "dynamics/contacts/contact_block.hpp"

namespace tumble {

namespace {

// A block of neutral lanes.
ContactBlock make_neutral_block() {
    ContactBlock block;
    const Lanes zero = Lanes::Zero();
    std::fill_n(block.body_a, kLaneCount, kStaticSolverBody);
    std::fill_n(block.body_b, kLaneCount, kStaticSolverBody);
    block.moved_a = block.moved_b = 0;
    for (Lanes* lanes : {&block.normal_x, &block.normal_y, &block.inv_mass_a, &block.inv_mass_b, &block.inv_inertia_a,
                         &block.inv_inertia_b, &block.coupling, &block.friction})
        *lanes = zero;
    for (ContactBlockPoint& point : block.points) {
        for (Lanes* lanes :
             {&point.along_a, &point.across_a, &point.along_b, &point.across_b, &point.normal_impulse,
              &point.tangent_mass, &point.tangent_impulse, &point.applied_normal, &point.applied_tangent})
            *lanes = zero;
        point.separation = Lanes::Constant(kAbsentGap);
        point.inverse_mass = Lanes::Ones();
    }
    block.has_locks = block.has_radius = block.has_restitution = block.has_tangent_speed =
        block.has_rolling_resistance = false;
    block.extras = nullptr;
    return block;
}

// A bit for the lane if a contact can move the body.
std::uint8_t moved_bit(int lane, const BodyFrame& body) {
    const Vec2 masses = body.inv_masses();
    const bool moves = masses.x > 0.0f || masses.y > 0.0f || body.inv_inertia > 0.0f;
    return static_cast<std::uint8_t>(static_cast<unsigned>(moves) << lane);
}

void fill_lane(ContactBlock& block, int lane, const Contact& contact, const BodyFrame& a, const BodyFrame& b) {
    TUMBLE_CHECK(lane < kLaneCount);
    TUMBLE_CHECK(contact.kind == ContactKind::solid);
    TUMBLE_CHECK(contact.manifold.point_count > 0);
    TUMBLE_CHECK(contact.manifold.point_count <= 2);
    block.body_a[lane] = a.solver_body;
    block.body_b[lane] = b.solver_body;
    block.moved_a |= moved_bit(lane, a);
    block.moved_b |= moved_bit(lane, b);
    const Vec2 normal = contact.manifold.normal;
    TUMBLE_CHECK(!(std::abs(length_sq(normal) - 1.0f) > 1e-3f));  // unit, or not finite in a world that diverges
    block.normal_x[lane] = normal.x;
    block.normal_y[lane] = normal.y;
    block.inv_mass_a[lane] = a.inv_mass;
    block.inv_mass_b[lane] = b.inv_mass;
    block.inv_inertia_a[lane] = a.inv_inertia;
    block.inv_inertia_b[lane] = b.inv_inertia;
    block.friction[lane] = contact.friction;
    block.has_locks |= a.locks_x || a.locks_y || b.locks_x || b.locks_y;
    block.has_radius |= contact.radius_a > 0.0f || contact.radius_b > 0.0f;
    block.has_restitution |= contact.restitution > 0.0f;
    block.has_tangent_speed |= contact.tangent_speed != 0.0f;
    block.has_rolling_resistance |= contact.rolling_resistance > 0.0f;
    for (int i = 0; i < contact.manifold.point_count; ++i) {
        const ManifoldPoint& from = contact.manifold.points[i];
        const Vec2 arm_a = from.anchor_a - a.center_offset;
        const Vec2 arm_b = from.anchor_b - b.center_offset;
        ContactBlockPoint& to = block.points[i];
        to.along_a[lane] = dot(arm_a, normal);
        to.across_a[lane] = cross(arm_a, normal);
        to.along_b[lane] = dot(arm_b, normal);
        to.across_b[lane] = cross(arm_b, normal);
        to.separation[lane] = from.separation;
        to.normal_impulse[lane] = contact.impulses[i].normal;
        to.tangent_impulse[lane] = contact.impulses[i].tangent;
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
    const Lanes limited = clamp_magnitude(coupling, kMaxCoupling * product.sqrt());
    block.coupling = select_less(second.separation, absent, limited, zero);
    if (!block.has_rolling_resistance) return;
    const Lanes inertia = block.inv_inertia_a + block.inv_inertia_b;
    block.extras->rolling_mass = select_less(zero, inertia, one / inertia, zero);
}

// The normal velocities with which points reach separation 0, from those before the step (RESTITUTION.md, step 2).
void set_approaches(ContactBlock& block, const BodyStore& bodies, Vec2 gravity, float h) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t body_a = block.body_a[lane], body_b = block.body_b[lane];
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
void prefetch(std::span<const Contact> contacts, std::span<const std::uint32_t> block) {
    constexpr std::size_t kCacheLine = 64;
    for (const std::uint32_t index : block) {
        if (index == ConstraintGraph::kNoContact) continue;
        const char* const contact = reinterpret_cast<const char*>(&contacts[index]);
        for (std::size_t line = 0; line < 3; ++line) __builtin_prefetch(contact + line * kCacheLine);
    }
}

constexpr std::size_t kLeastPrepared = 16;  // in a chunk: about 3 us of work

// The softness of contacts between moving bodies, and of those with a body that does not move.
struct ContactSoftness {
    Softness moving, immovable;
};

// A member of each contact; 0 in unused lanes.
void fill_from(Lanes& to, std::span<const std::uint32_t, kLaneCount> lanes, std::span<const Contact> contacts,
               float Contact::*member) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t contact = lanes[static_cast<std::size_t>(lane)];
        to[lane] = contact == ConstraintGraph::kNoContact ? 0.0f : contacts[contact].*member;
    }
}

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

// What the flags of a block say that it has.
void fill_rest(ContactBlock& block, std::span<const std::uint32_t, kLaneCount> lanes, std::span<const Contact> contacts,
               const BodyStore& bodies) {
    if (block.has_locks) {
        static const BodyFrame immovable;
        for (int lane = 0; lane < kLaneCount; ++lane) {
            const std::uint32_t index = lanes[static_cast<std::size_t>(lane)];
            const bool is_used = index != ConstraintGraph::kNoContact;
            fill_locked_masses(block, lane, is_used ? bodies.frames[contacts[index].body_a] : immovable,
                               is_used ? bodies.frames[contacts[index].body_b] : immovable);
        }
    }
    if (block.has_radius) {
        fill_from(block.extras->radius_a, lanes, contacts, &Contact::radius_a);
        fill_from(block.extras->radius_b, lanes, contacts, &Contact::radius_b);
    }
    if (block.has_restitution) {
        fill_from(block.extras->restitution, lanes, contacts, &Contact::restitution);
        block.extras->absorbed = block.extras->friction_work = Lanes::Zero();
    }
    if (block.has_tangent_speed) fill_from(block.extras->tangent_speed, lanes, contacts, &Contact::tangent_speed);
    if (block.has_rolling_resistance) {
        fill_from(block.extras->rolling_resistance, lanes, contacts, &Contact::rolling_resistance);
        fill_from(block.extras->rolling_impulse, lanes, contacts, &Contact::rolling_impulse);
    }
}

void fill_block(ContactBlock& block, std::span<const std::uint32_t, kLaneCount> lanes,
                std::span<const Contact> contacts, const BodyStore& bodies, const ContactSoftness& softness) {
    bool is_static = false;  // the same for all lanes: colours separate them
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t contact = lanes[static_cast<std::size_t>(lane)];
        if (contact == ConstraintGraph::kNoContact) continue;
        TUMBLE_CHECK(contact < contacts.size());
        const BodyFrame& a = bodies.frames[contacts[contact].body_a];
        const BodyFrame& b = bodies.frames[contacts[contact].body_b];
        fill_lane(block, lane, contacts[contact], a, b);
        is_static = a.inv_mass == 0.0f || b.inv_mass == 0.0f;
    }
    block.softness = is_static ? softness.immovable : softness.moving;
    fill_rest(block, lanes, contacts, bodies);
    set_masses(block);
}

// Only a dynamic body is in one contact of a colour; several threads may have another body.
void mark_pushed(SolverBody& body) {
    if (body.flags & kDynamicBody) body.flags |= kPushedBody;
}

void store_block(const ContactBlock& block, std::span<const std::uint32_t, kLaneCount> lanes,
                 std::span<Contact> contacts, std::span<SolverBody> bodies) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const std::uint32_t index = lanes[static_cast<std::size_t>(lane)];
        if (index == ConstraintGraph::kNoContact) continue;
        TUMBLE_CHECK(index < contacts.size());
        Contact& contact = contacts[index];
        bool has_acted = false;
        for (int i = 0; i < contact.manifold.point_count; ++i) {
            const ContactBlockPoint& point = block.points[i];
            TUMBLE_CHECK(!(point.normal_impulse[lane] < 0.0f));
            contact.impulses[i] = {point.normal_impulse[lane], point.tangent_impulse[lane]};
            contact.applied[i] = {point.applied_normal[lane], point.applied_tangent[lane]};
            contact.is_touching |= point.applied_normal[lane] > 0.0f;
            has_acted |= point.applied_normal[lane] > 0.0f || point.applied_tangent[lane] != 0.0f ||
                         contact.manifold.points[i].separation < 0.0f;
        }
        if (has_acted) mark_pushed(bodies[block.body_a[lane]]), mark_pushed(bodies[block.body_b[lane]]);
        if (block.has_rolling_resistance) contact.rolling_impulse = block.extras->rolling_impulse[lane];
    }
}

}  // namespace

void prepare_contacts(std::span<const Contact> contacts, const BodyStore& bodies, const ConstraintGraph& graph,
                      const Tuning& tuning, Vec2 gravity, float h, std::vector<ContactBlock>& blocks,
                      std::vector<ContactExtras>& extras, Crew& crew) {
    TUMBLE_CHECK(h > 0.0f);
    blocks.resize(graph.block_count());
    extras.resize(graph.block_count());
    if (blocks.empty()) return;
    const ContactSoftness softness{contact_softness(tuning, h), static_contact_softness(tuning, h)};
    const ContactBlock neutral = make_neutral_block();
    crew.for_each(blocks.size(), kLeastPrepared, [&](std::size_t index) {
        if (index + 1 < blocks.size()) prefetch(contacts, graph.block(index + 1));
        ContactBlock& block = blocks[index];
        block = neutral;
        block.extras = &extras[index];
        fill_block(block, graph.block(index), contacts, bodies, softness);
        if (block.has_restitution) set_approaches(block, bodies, gravity, h);
    });
}

void store_impulses(const std::vector<ContactBlock>& blocks, const ConstraintGraph& graph, std::span<Contact> contacts,
                    std::span<SolverBody> bodies, Crew& crew) {
    for (const ConstraintGraph::Color& color : graph.colors()) {
        const auto store = [&](std::size_t i) {
            const std::size_t index = color.begin + i;
            if (index + 1 < blocks.size()) prefetch(contacts, graph.block(index + 1));
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
