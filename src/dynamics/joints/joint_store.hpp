// All joints, an array a kind. Every kind has the same skeleton: prepare, warm_start, solve, reaction; a new kind is a
// file, a line in KindList and a definition in joint.hpp.
//
// A joint stays where it was created; each kind lists those that are awake, in order of their ids. A joint sleeps with
// its bodies and costs nothing then.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "dynamics/bodies/id_pool.hpp"
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
#include "tumble/joint.hpp"

namespace tumble {

bool collides_connected(const JointDef& def);

// The bodies that a joint acts on, each once.
class TiedBodies {
public:
    void add(BodyId body) {
        if (std::find(begin(), end(), body) == end()) bodies_[count_++] = body;
    }
    const BodyId* begin() const { return bodies_.data(); }
    const BodyId* end() const { return bodies_.data() + count_; }

    // Calls visit(body, other), by index, for every two of them.
    template <class Visitor>
    void for_each_pair(Visitor&& visit) const {
        for (const BodyId* body = begin(); body != end(); ++body)
            for (const BodyId* other = body + 1; other != end(); ++other) visit(body->index, other->index);
    }

private:
    std::array<BodyId, 4> bodies_;
    std::size_t count_ = 0;
};

// What a joint bears.
struct JointStrength {
    float force = kUnbreakable;   // N
    float torque = kUnbreakable;  // N m
};
JointStrength joint_strength(const JointDef& def);

class JointStore {
public:
    JointId create(const JointDef& def);
    void destroy(JointId id);
    const JointDef& def(JointId id) const { return records_[id.index].def; }
    TiedBodies bodies(JointId id) const;  // two; of a gear those of its joints
    JointReaction reaction(JointId id) const { return loads_[id.index].reaction; }
    float position(JointId id) const;  // angle, way or length, as the kind has it

    // Another definition of the same kind and bodies; the impulses go on.
    void redefine(JointId id, const JointDef& def);

    // The next step solves the joint as if it had just been made.
    void forget_impulses(JointId id);

    bool is_awake(JointId id) const { return records_[id.index].is_awake; }
    void wake(JointId id);
    void put_to_sleep(std::span<const JointId> ids);

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    void store(const JointContext& context);

    // Those that broke in the last store(), in order of their ids.
    const std::vector<JointId>& broken() const { return broken_; }

    // Calls visit(body, other), by index, for every two bodies of each joint that is awake.
    template <class Visitor>
    void for_each_awake_pair(Visitor&& visit) const {
        for_each_list(*this, [&](const auto& list) {
            for (const AwakeJoint& awake : list.awake) bodies(ids.at(awake.joint)).for_each_pair(visit);
        });
    }

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
    // Apart from the record, as each step writes it.
    struct JointLoad {
        JointReaction reaction;  // in the last step that it was awake
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
        std::vector<std::uint32_t> free;  // slots
        std::vector<AwakeJoint> awake;    // sorted unless woken since the last step
    };
    template <class... Joints>
    using Lists = std::tuple<JointList<Joints>...>;
    // In order of solving.
    using KindList = Lists<MouseJoint, MotorJoint, DistanceJoint, PulleyJoint, GearJoint, WheelJoint, PrismaticJoint,
                           RevoluteJoint, WeldJoint, FilterJoint>;

    template <class Self, class Visitor>
    static void for_each_list(Self& self, Visitor&& visit) {
        std::apply([&](auto&... list) { (visit(list), ...); }, self.lists_);
    }
    template <class Self, class Visitor>
    static void for_each_awake(Self& self, Visitor&& visit) {
        for_each_list(self, [&](auto& list) {
            for (const AwakeJoint& awake : list.awake) visit(list.joints[awake.slot]);
        });
    }
    // The joint that a definition makes, as its list holds it.
    template <class Def>
    auto make(const Def& def) const;
    template <class Self, class Visitor>
    static void visit_list_of(Self& self, JointId id, Visitor&& visit);

    std::vector<JointRecord> records_;  // by joint index
    std::vector<JointLoad> loads_;      // by joint index
    KindList lists_;
    std::vector<JointId> broken_;
    bool is_unsorted_ = false;  // joints were added to the awake ones
};

}  // namespace tumble
