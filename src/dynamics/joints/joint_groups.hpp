// Which joints the direct solver takes.
//
// With JointSolver::direct it takes all. With JointSolver::iterative it takes those that iteration solves worst. A
// group is a set of joints with equality constraints that are connected through dynamic bodies. The direct solver takes
// a group that a static or kinematic body holds, if the group is small, such as a double pendulum or a four-bar
// linkage, or if one of its bodies is much heavier than another, such as the weight at the end of a chain. While one of
// its bodies touches another dynamic body, the group is iterated: the contact solver and the direct solver would
// disturb each other. ../SOFTNESS.md, steps 15 and 16, has the figures.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/joints/joined_bodies.hpp"
#include "tumble/joint.hpp"

namespace tumble {

class JointGroups {
public:
    // Finds the groups anew: after a change of the awake joints, or of the type or mass of a joined body. `joined`, by
    // joint index: the bodies of the awake joints that have equality constraints; empty for all others.
    void find(JointSolver solver, const std::vector<JoinedBodies>& joined, const BodyStore& bodies);

    // Decides for this step. touches_dynamic(solver_body) is true if a dynamic body touches another one.
    template <class TouchesDynamic>
    void choose(const BodyStore& bodies, TouchesDynamic&& touches_dynamic) {
        if (solver_ == JointSolver::direct) return;
        has_direct_ = false;
        for (const Group& group : groups_) {
            const bool is_direct = std::none_of(group.bodies.begin(), group.bodies.end(), [&](std::uint32_t body) {
                TUMBLE_CHECK(bodies.is_dynamic(body));
                return touches_dynamic(bodies.frames[body].solver_body);
            });
            has_direct_ |= is_direct;
            for (const std::uint32_t joint : group.joints) is_direct_[joint] = is_direct;
        }
    }

    bool has_direct() const { return has_direct_; }
    bool is_direct(std::uint32_t joint) const { return is_direct_[joint]; }

    std::size_t bytes() const;

private:
    struct Group {
        std::vector<std::uint32_t> joints;  // indices
        std::vector<std::uint32_t> bodies;  // indices of those that are dynamic, some more than once
        bool is_held = false;
    };
    // The group of a joint. Removes its joints from those that are left, by joint index.
    static Group take_group(std::uint32_t first, std::vector<bool>& left, const std::vector<JoinedBodies>& joined,
                            const BodyStore& bodies);
    static bool suits(const Group& group, const BodyStore& bodies);

    JointSolver solver_ = JointSolver::iterative;
    std::vector<Group> groups_;    // that the direct solver may take
    std::vector<bool> is_direct_;  // by joint index
    bool has_direct_ = false;
};

}  // namespace tumble
