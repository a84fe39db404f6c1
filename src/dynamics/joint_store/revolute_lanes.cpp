#include "dynamics/joint_store/revolute_lanes.hpp"

#include <algorithm>
#include <cstddef>

#include "dynamics/joint_store/revolute_block.hpp"
#include "simd/transpose.hpp"

namespace tumble {

namespace {

// Threads share the bundles of a colour. Larger: threads wait for each other. Smaller: levels have too few joints to
// fill lanes.
constexpr std::size_t kBlocksOfBundle = 3;

// Fewer joints take less time alone.
constexpr std::size_t kLeastLanes = 3;

// The kind of joints that no lanes can solve; that of the others are the parts of their drives.
constexpr std::uint32_t kAlone = kSpringPart + kMotorPart + kLimitsPart + 1;

constexpr std::size_t kLeastLoaded = 12;  // blocks in a chunk: about 3 us of work

}  // namespace

RevoluteLanes::RevoluteLanes() = default;
RevoluteLanes::~RevoluteLanes() = default;
RevoluteLanes::RevoluteLanes(const RevoluteLanes&) = default;
RevoluteLanes::RevoluteLanes(RevoluteLanes&&) noexcept = default;
RevoluteLanes& RevoluteLanes::operator=(const RevoluteLanes&) = default;
RevoluteLanes& RevoluteLanes::operator=(RevoluteLanes&&) noexcept = default;

std::size_t RevoluteLanes::bytes() const {
    return (colors_.capacity() + bundles_.capacity()) * sizeof(Range) + items_.capacity() * sizeof(Item) +
           is_in_lanes_.capacity() / 8 + blocks_.capacity() * sizeof(RevoluteBlock) +
           placed_.capacity() * sizeof(Placed) + (lanes_.capacity() + levels_.capacity()) * sizeof(std::uint32_t);
}

void RevoluteLanes::find(const JointBlocks& order, std::span<const Entry> entries,
                         std::span<const RevoluteJoint> joints, const BodyStore& bodies) {
    colors_.clear();
    bundles_.clear();
    items_.clear();
    blocks_.clear();
    lanes_.clear();
    is_in_lanes_.assign(entries.size(), false);
    levels_.assign(bodies.frames.size(), 0);
    order.for_each_color([&](std::span<const std::uint32_t> color) {
        const std::size_t count = (color.size() + kBlocksOfBundle - 1) / kBlocksOfBundle;
        const auto first = static_cast<std::uint32_t>(bundles_.size());
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t begin = color.size() * i / count, end = color.size() * (i + 1) / count;
            add_bundle(order, color.subspan(begin, end - begin), entries, joints, bodies);
        }
        colors_.push_back({first, static_cast<std::uint32_t>(bundles_.size())});
    });
}

void RevoluteLanes::add_bundle(const JointBlocks& order, std::span<const std::uint32_t> of,
                               std::span<const Entry> entries, std::span<const RevoluteJoint> joints,
                               const BodyStore& bodies) {
    const auto for_each_joint = [&](auto&& visit) {
        for (const std::uint32_t block : of)
            for (std::size_t i = order.first(block); i < order.first(block + 1); ++i)
                visit(static_cast<std::uint32_t>(i), joints[entries[i].slot]);
    };
    placed_.clear();
    for_each_joint([&](std::uint32_t i, const RevoluteJoint& joint) {
        std::uint32_t level = 0;
        for (const std::uint32_t body : {joint.body_a(), joint.body_b()})
            if (bodies.frames[body].can_move()) level = std::max(level, levels_[body]);
        for (const std::uint32_t body : {joint.body_a(), joint.body_b()}) levels_[body] = level + 1;
        placed_.push_back({level, entries[i].fits_lanes ? joint.drive_parts() : kAlone, i});
    });
    for_each_joint(
        [&](std::uint32_t, const RevoluteJoint& joint) { levels_[joint.body_a()] = levels_[joint.body_b()] = 0; });
    std::sort(placed_.begin(), placed_.end());
    const auto first = static_cast<std::uint32_t>(items_.size());
    for (auto begin = placed_.begin(); begin != placed_.end();) {
        const auto end = std::find_if(begin, placed_.end(), [&](const Placed& other) {
            return other.level != begin->level || other.kind != begin->kind;
        });
        add_alike({begin, end}, entries);
        begin = end;
    }
    bundles_.push_back({first, static_cast<std::uint32_t>(items_.size())});
}

void RevoluteLanes::add_alike(std::span<const Placed> alike, std::span<const Entry> entries) {
    while (alike.size() >= kLeastLanes && alike[0].kind != kAlone) {
        const std::size_t used = std::min(alike.size(), std::size_t{kLaneCount});
        items_.push_back({static_cast<std::uint32_t>(blocks_.size()), true});
        RevoluteBlock& block = blocks_.emplace_back();
        block.set_parts(alike[0].kind);
        // The first joint is in the unused lanes too.
        for (std::size_t lane = 0; lane < kLaneCount; ++lane)
            lanes_.push_back(entries[alike[lane < used ? lane : 0].position].slot);
        for (const Placed& joint : alike.first(used)) is_in_lanes_[joint.position] = true;
        alike = alike.subspan(used);
    }
    for (const Placed& joint : alike) items_.push_back({joint.position, false});
}

TUMBLE_LANE_KERNEL void RevoluteLanes::write_lanes(RevoluteBlock& block, const RevoluteJoint* const joints[], float h) {
    const JointBodies* bodies[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) bodies[lane] = &joints[lane]->bodies_;
    constexpr std::size_t kMasses = offsetof(JointBodies, inv_mass_a), kArms = offsetof(JointBodies, arm_a);
    static_assert(offsetof(JointBodies, inv_mass_b) == kMasses + 8);
    static_assert(offsetof(JointBodies, inv_inertia_a) == kMasses + 16);
    static_assert(offsetof(JointBodies, arm_b) == kArms + 8);
    static_assert(offsetof(JointBodies, center_difference) == kArms + 16);
    // Eight floats from the arms on would end beyond the record.
    static_assert(kArms - 8 == offsetof(JointBodies, inv_inertia_b) && sizeof(JointBodies) == kArms + 24);
    Lanes masses[8], arms[8];
    gather_members(bodies, kMasses, masses);
    gather_members(bodies, kArms - 8, arms);
    block.inv_mass_a = masses[0];
    block.inv_mass_b = masses[2];
    block.inv_inertia_a = masses[4];
    block.inv_inertia_b = masses[5];
    block.arm_ax = arms[2];
    block.arm_ay = arms[3];
    block.arm_bx = arms[4];
    block.arm_by = arms[5];
    block.center_x = arms[6];
    block.center_y = arms[7];
    for (int lane = 0; lane < kLaneCount; ++lane) write_lane(block, lane, *joints[lane], h);
}

// What is not in a row of floats.
void RevoluteLanes::write_lane(RevoluteBlock& block, int lane, const RevoluteJoint& joint, float h) {
    block.body_a[lane] = BodyRow::of(joint.bodies_.a);
    block.body_b[lane] = BodyRow::of(joint.bodies_.b);
    block.impulse_x[lane] = joint.impulse_.x;
    block.impulse_y[lane] = joint.impulse_.y;
    if (!block.has_drive()) return;
    const JointDrive& drive = joint.drive_;
    const DriveImpulses& impulses = drive.impulses();
    block.angle[lane] = joint.angle_.at_start();
    block.spring_impulse[lane] = impulses.spring;
    block.motor_impulse[lane] = impulses.motor;
    block.lower_impulse[lane] = impulses.lower;
    block.upper_impulse[lane] = impulses.upper;
    if (block.has_spring) {
        const Softness softness = spring_softness(*drive.spring(), h);
        block.spring_bias_rate[lane] = softness.bias_rate;
        block.spring_mass_scale[lane] = softness.mass_scale;
        block.spring_impulse_scale[lane] = softness.impulse_scale;
    }
    if (block.has_motor) {
        block.motor_speed[lane] = drive.motor()->speed;
        block.motor_most[lane] = h * drive.motor()->max_effort;
    }
    if (block.has_limits) {
        block.lower[lane] = drive.limits()->lower;
        block.upper[lane] = drive.limits()->upper;
    }
}

void RevoluteLanes::load(std::span<const RevoluteJoint> joints, const BodyStore& bodies, float h, Crew& crew) {
    crew.for_each(blocks_.size(), kLeastLoaded, [&](std::size_t i) {
        RevoluteBlock& block = blocks_[i];
        block.moved_a = block.moved_b = 0;
        const RevoluteJoint* eight[kLaneCount];
        for (int lane = 0; lane < kLaneCount; ++lane) {
            const RevoluteJoint& joint = joints[lanes_[kLaneCount * i + static_cast<std::size_t>(lane)]];
            eight[lane] = &joint;
            const auto bit = [&](std::uint32_t body) {
                return static_cast<std::uint8_t>(static_cast<unsigned>(bodies.frames[body].can_move()) << lane);
            };
            block.moved_a |= bit(joint.body_a());
            block.moved_b |= bit(joint.body_b());
        }
        write_lanes(block, eight, h);
    });
}

void RevoluteLanes::store(std::span<RevoluteJoint> joints, Crew& crew) const {
    crew.for_each(blocks_.size(), kLeastLoaded, [&](std::size_t i) {
        const RevoluteBlock& block = blocks_[i];
        for (int lane = 0; lane < kLaneCount; ++lane) {
            RevoluteJoint& joint = joints[lanes_[kLaneCount * i + static_cast<std::size_t>(lane)]];
            joint.impulse_ = {block.impulse_x[lane], block.impulse_y[lane]};
            if (block.has_drive())
                joint.drive_.set_impulses({block.spring_impulse[lane], block.motor_impulse[lane],
                                           block.lower_impulse[lane], block.upper_impulse[lane]});
        }
    });
}

}  // namespace tumble
