// Which joints the direct solver takes.
//
// With JointSolver::direct it takes all. With JointSolver::iterative it takes those that iteration solves worst, and
// that are cheap. A group is a set of joints with equality constraints that are connected through dynamic bodies. The
// direct solver takes a group that is held by a static or kinematic body, if the group is small, such as a double
// pendulum or a four-bar linkage, or if one of its bodies is much heavier than another, such as the weight at the end
// of a chain. While one of its bodies touches another dynamic body, the group is iterated: the contact solver and the
// direct solver would disturb each other. ../SOFTNESS.md, section 4, has the figures.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/contacts/constraint_graph.hpp"
#include "tumble/joint.hpp"

namespace tumble {

class JointStore;

class JointGroups {
public:
    // Finds the groups anew: after a change of the awake joints, or of the type or mass of a joined body.
    // `is_candidate`, by joint index: the awake joints that have equality constraints.
    void find(JointSolver solver, const std::vector<bool>& is_candidate, const JointStore& joints,
              const BodyStore& bodies);

    // Decides for this step. `contacts` are those of the step.
    void choose(const BodyStore& bodies, const ConstraintGraph& contacts);

    bool has_direct() const { return has_direct_; }
    bool is_direct(std::uint32_t joint) const { return is_direct_[joint]; }

    std::size_t bytes() const;

private:
    struct Group {
        std::vector<std::uint32_t> joints;  // indices
        std::vector<std::uint32_t> bodies;  // indices of those that are dynamic
        bool is_held = false;
    };
    // The group of a candidate, which it removes from the candidates with all others of the group.
    static Group take_group(std::uint32_t first, std::vector<bool>& candidates, const JointStore& joints,
                            const BodyStore& bodies);
    static bool suits(const Group& group, const BodyStore& bodies);

    JointSolver solver_ = JointSolver::iterative;
    std::vector<Group> groups_;    // that the direct solver may take
    std::vector<bool> is_direct_;  // by joint index
    bool has_direct_ = false;
};

}  // namespace tumble
