// Which joints the direct solver takes, and which are the only joints with rows of their bodies (rows/lone_joint.hpp).
//
// With JointSolver::direct it takes all. With JointSolver::iterative it takes those of small mechanisms, such as a
// double pendulum or a four-bar linkage: groups of few rigid joints that a static or kinematic body holds, while none
// of their bodies has a contact. A group is a set of joints that are connected through dynamic bodies. A rigid joint
// has no limits, motors and springs. ../SOFTNESS.md, steps 17 to 19, says why no others.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/joint_store/joined_bodies.hpp"
#include "tumble/joint.hpp"

namespace tumble {

// What the rows of a joint are: none (of a filter joint), equality constraints alone, or others too.
enum class JointRows : std::uint8_t { none, rigid, other };

struct GroupedJoint {
    JointRows rows = JointRows::none;  // also of a joint that sleeps
    JoinedBodies bodies;
};

class JointGroups {
public:
    // Finds the groups anew: after a change of the awake joints, of their rows, or of the type or mass of a joined
    // body. `joints` by joint index.
    void find(JointSolver solver, const std::vector<GroupedJoint>& joints, const BodyStore& bodies);

    // Decides for this step. has_contact(solver_body) is true if the solver presses on a dynamic body in this step.
    template <class HasContact>
    void choose(const BodyStore& bodies, HasContact&& has_contact) {
        if (solver_ == JointSolver::direct) return;
        has_direct_ = false;
        for (const Group& group : groups_) {
            const bool is_direct = std::none_of(group.bodies.begin(), group.bodies.end(), [&](std::uint32_t body) {
                TUMBLE_CHECK(bodies.is_dynamic(body));
                return has_contact(bodies.frames[body].solver_body);
            });
            has_direct_ |= is_direct;
            for (const std::uint32_t joint : group.joints) is_direct_[joint] = is_direct;
        }
    }

    // False if the direct solver takes the joint in no step, until find() is called again.
    bool may_be_direct(std::uint32_t joint) const {
        TUMBLE_CHECK(joint < may_be_direct_.size());
        return may_be_direct_[joint];
    }

    bool has_direct() const { return has_direct_; }
    bool is_direct(std::uint32_t joint) const {
        TUMBLE_CHECK(joint < is_direct_.size());
        return is_direct_[joint];
    }

    // Whether no other joint with rows acts on the dynamic bodies of the joint. False if the solver takes all directly.
    bool is_lone(std::uint32_t joint) const {
        TUMBLE_CHECK(joint < is_lone_.size());
        return is_lone_[joint];
    }

    std::size_t bytes() const;

private:
    struct Group {
        std::vector<std::uint32_t> joints;  // indices
        std::vector<std::uint32_t> bodies;  // indices of those that are dynamic, ascending
        bool is_held = false;
        bool is_rigid = true;
    };
    // The group of a joint. Removes its joints from those that are left, by joint index.
    static Group take_group(std::uint32_t first, std::vector<bool>& left, const std::vector<GroupedJoint>& joints,
                            const BodyStore& bodies);
    static bool suits(const Group& group, const BodyStore& bodies);

    JointSolver solver_ = JointSolver::iterative;
    std::vector<Group> groups_;                  // that the direct solver may take
    std::vector<bool> is_direct_;                // by joint index
    std::vector<bool> may_be_direct_, is_lone_;  // by joint index
    bool has_direct_ = false;
};

}  // namespace tumble
