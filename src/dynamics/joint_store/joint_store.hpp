// All joints of a world, in one array for each kind. The kinds have the same member functions: prepare,
// update_rows, warm_start, solve, visit_equalities, reaction, position, take_over, forget_impulses. README.md lists the
// files to touch for a new kind.
//
// A joint keeps its slot in the array of its kind from creation to destruction. Each kind lists its awake joints in
// order of their ids, and a step visits only these: a sleeping joint costs nothing.
#pragma once

#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/bodies/id_pool.hpp"
#include "dynamics/joint_store/joined_bodies.hpp"
#include "dynamics/joint_store/joint_blocks.hpp"
#include "dynamics/joint_store/joint_groups.hpp"
#include "dynamics/joint_store/revolute_lanes.hpp"
#include "dynamics/joints/distance_joint.hpp"
#include "dynamics/joints/filter_joint.hpp"
#include "dynamics/joints/gear_joint.hpp"
#include "dynamics/joints/motor_joint.hpp"
#include "dynamics/joints/mouse_joint.hpp"
#include "dynamics/joints/prismatic_joint.hpp"
#include "dynamics/joints/pulley_joint.hpp"
#include "dynamics/joints/revolute_joint.hpp"
#include "dynamics/joints/weld_joint.hpp"
#include "dynamics/joints/wheel_joint.hpp"
#include "tasks/crew.hpp"
#include "tumble/joint.hpp"

namespace tumble {

// True if the shapes of the two bodies may collide.
bool collides_connected(const JointDef& def);

// The reaction beyond which a joint breaks.
struct JointStrength {
    float force = kUnbreakable;   // N
    float torque = kUnbreakable;  // N m
};
JointStrength joint_strength(const JointDef& def);

class JointStore {
public:
    // Adds an awake joint. The caller updates the lists of joints of its bodies.
    JointId create(const JointDef& def);
    void destroy(JointId id);
    const JointDef& def(JointId id) const {
        TUMBLE_CHECK(id.index < records_.size());
        return records_[id.index].def;
    }
    JoinedBodies bodies(JointId id) const;  // of a gear those of its two joints
    JointReaction reaction(JointId id) const { return loads_[id.index].reaction; }
    float position(JointId id) const;  // angle, displacement or length: see World::joint_position()

    // Gives a joint another definition of the same kind and bodies. Its accumulated impulses are kept.
    void redefine(JointId id, const JointDef& def);

    void set_user_data(JointId id, std::uint64_t data);

    // Clears the accumulated impulses: the next step solves the joint without warm start.
    void forget_impulses(JointId id);

    bool is_awake(JointId id) const { return records_[id.index].is_awake; }
    void wake(JointId id);
    void put_to_sleep(std::span<const JointId> ids);

    void prepare(const BodyStore& bodies, JointSolver solver, float h, Crew& crew);  // h: the sub-step, s

    // After prepare(), when the contacts of the step are known: decides which joints the direct solver takes.
    template <class HasContact>
    void choose_direct(const BodyStore& bodies, HasContact&& has_contact) {
        groups_.choose(bodies, has_contact);
    }

    // To be called after a change of the type, mass or locks of a body with joints.
    void forget_groups() { has_groups_ = false; }

    bool has_direct() const { return groups_.has_direct(); }
    void warm_start(std::span<SolverBody> bodies, Crew& crew) const;
    // Solves each joint once. The relaxing pass, without bias, updates the rows first: the bodies have moved since the
    // pass with bias. In a loop of its own, the update would read all joints once more.
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies, Crew& crew);

    // Calls visit(EqualityRow) for each equality constraint that the direct solver takes, at the given deltas of the
    // bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        for_each_list(*this, [&](auto& list) {
            for (const AwakeJoint& awake : list.awake)
                if (groups_.is_direct(awake.joint)) list.joints[awake.slot].visit_equalities(bodies, visit);
        });
    }

    // Stores the reactions of the awake joints, and lists those that break.
    void store(const JointContext& context, Crew& crew);

    // The joints whose reaction exceeded their strength in the last store(), in order of their ids.
    const std::vector<JointId>& broken() const { return broken_; }

    // Calls visit(body, other, has_rows) for each two bodies, by index, of each awake joint. A joint without rows
    // neither pushes nor pulls.
    template <class Visitor>
    void for_each_awake_pair(Visitor&& visit) const {
        for_each_list(*this, [&](const auto& list) {
            for (const AwakeJoint& awake : list.awake)
                bodies(ids.at(awake.joint)).for_each_pair([&](std::uint32_t body, std::uint32_t other) {
                    visit(body, other, has_rows(list));
                });
        });
    }

    std::size_t awake_count() const {
        std::size_t count = 0;
        for_each_list(*this, [&](const auto& list) { count += list.awake.size(); });
        return count;
    }

    // Of what is derived from the joints.
    std::size_t derived_bytes() const {
        std::size_t bytes = groups_.bytes() + revolute_lanes_.bytes();
        for_each_list(*this, [&](const auto& list) { bytes += list.blocks.bytes(); });
        return bytes;
    }

    // An invariant: each joint has its load.
    bool has_all_loads() const { return loads_.size() == records_.size(); }

    IdPool<JointId> ids;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.ids, self.records_, self.loads_, self.broken_, self.is_unsorted_);
        for_each_list(self, [&](auto& list) { visit(list.joints, list.free, list.awake); });
    }

private:
    struct JointRecord {
        JointDef def;
        std::uint32_t slot = 0;  // in the list of its kind
        bool is_awake = false;
    };
    // Kept apart from the record, as each step writes it.
    struct JointLoad {
        JointReaction reaction;  // of the last step in which the joint was awake
        JointStrength strength;
    };
    struct AwakeJoint {
        std::uint32_t joint = 0;  // index
        std::uint32_t slot = 0;

        friend constexpr auto operator<=>(AwakeJoint, AwakeJoint) = default;
    };
    template <class Joint>
    struct JointList {
        std::vector<Joint> joints;        // by slot
        std::vector<std::uint32_t> free;  // slots without a joint
        std::vector<AwakeJoint> awake;    // sorted by prepare()
        JointBlocks blocks;               // of these; derived, like the groups
    };
    template <class Joint>
    static constexpr bool has_rows(const JointList<Joint>&) {
        return !std::is_same_v<Joint, FilterJoint>;
    }
    template <class... Joints>
    using Lists = std::tuple<JointList<Joints>...>;
    // In the order in which the kinds are solved: the last ones are the most exact.
    using KindList = Lists<MouseJoint, MotorJoint, DistanceJoint, PulleyJoint, GearJoint, WheelJoint, PrismaticJoint,
                           RevoluteJoint, WeldJoint, FilterJoint>;

    template <class Self, class Visitor>
    static void for_each_list(Self& self, Visitor&& visit) {
        std::apply([&](auto&... list) { (visit(list), ...); }, self.lists_);
    }
    template <class Self, class List, class VisitBlock, class Visitor>
    static void for_each_in_blocks(Self& self, List& list, Crew& crew, VisitBlock&& visit_block, Visitor&& visit);
    // The joint of a definition, of the type of its kind.
    template <class Def>
    auto make(const Def& def) const;
    // Calls visit(list, def) with the list that contains a joint and its definition, both of the joint's kind.
    template <class Self, class Visitor>
    static void visit_list_of(Self& self, JointId id, Visitor&& visit);

    template <class Joint>
    bool is_in_lanes(const JointList<Joint>&, std::size_t) const {
        return false;
    }
    bool is_in_lanes(const JointList<RevoluteJoint>&, std::size_t position) const {
        return revolute_lanes_.is_in_lanes(position);
    }

    void find_groups(const BodyStore& bodies, JointSolver solver);
    void find_blocks(const BodyStore& bodies);
    void find_lanes(const BodyStore& bodies);

    std::vector<JointRecord> records_;  // by joint index
    std::vector<JointLoad> loads_;      // by joint index
    KindList lists_;
    std::vector<JointId> broken_;
    bool is_unsorted_ = false;  // an awake list got joints since the last prepare()

    // Derived from the joints and their bodies; a snapshot does not contain them.
    JointGroups groups_;
    RevoluteLanes revolute_lanes_;
    bool has_groups_ = false;
};

}  // namespace tumble
