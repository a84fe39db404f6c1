#include "dynamics/joint_store/joint_groups.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tumble {

namespace {

// The most joints of a group. Each costs some 2500 instructions in a sub-step. Lower: linkages of four bars lose
// energy.
constexpr std::size_t kMostJoints = 4;

// The most that a body may have of the mass of the lightest one of its group. Higher: a contact, which leaves the group
// to the iteration, lets it sag by more than 6 cm, and it jumps back when the contact ends.
constexpr float kLargestMassRatio = 100.0f;

}  // namespace

JointGroups::Group JointGroups::take_group(std::uint32_t first, std::vector<bool>& left,
                                           const std::vector<GroupedJoint>& joints, const BodyStore& bodies) {
    Group group;
    const auto take = [&](std::uint32_t joint) {
        if (!left[joint]) return;
        left[joint] = false;
        group.joints.push_back(joint);
    };
    take(first);
    for (std::size_t i = 0; i < group.joints.size(); ++i) {
        const GroupedJoint& joint = joints[group.joints[i]];
        group.is_rigid &= joint.rows == JointRows::rigid;
        for (const BodyId body : joint.bodies) {
            group.is_held |= !bodies.is_dynamic(body.index);
            if (!bodies.is_dynamic(body.index)) continue;
            group.bodies.push_back(body.index);
            for (const JointId other : bodies.records[body.index].joints) take(other.index);
        }
    }
    std::sort(group.bodies.begin(), group.bodies.end());
    group.bodies.erase(std::unique(group.bodies.begin(), group.bodies.end()), group.bodies.end());
    return group;
}

bool JointGroups::suits(const Group& group, const BodyStore& bodies) {
    if (!group.is_held || !group.is_rigid || group.joints.size() > kMostJoints) return false;
    // The only joint with rows of its bodies has a solution of its own (rows/lone_joint.hpp).
    if (group.joints.size() == 1) return false;
    float lightest = std::numeric_limits<float>::infinity(), heaviest = 0.0f;
    for (const std::uint32_t body : group.bodies) {
        lightest = std::min(lightest, bodies.records[body].mass.mass);
        heaviest = std::max(heaviest, bodies.records[body].mass.mass);
    }
    return heaviest <= kLargestMassRatio * lightest;
}

void JointGroups::find(JointSolver solver, const std::vector<GroupedJoint>& joints, const BodyStore& bodies) {
    solver_ = solver;
    groups_.clear();
    is_direct_.assign(joints.size(), solver == JointSolver::direct);
    may_be_direct_ = is_direct_;
    is_lone_.assign(joints.size(), false);
    has_direct_ = solver == JointSolver::direct;
    if (solver == JointSolver::direct) return;
    std::vector<bool> left(joints.size());
    for (std::size_t joint = 0; joint < joints.size(); ++joint) left[joint] = joints[joint].rows != JointRows::none;
    for (std::uint32_t joint = 0; joint < joints.size(); ++joint) {
        if (!left[joint]) continue;
        Group group = take_group(joint, left, joints, bodies);
        is_lone_[joint] = group.joints.size() == 1;
        if (!suits(group, bodies)) continue;
        for (const std::uint32_t taken : group.joints) may_be_direct_[taken] = true;
        groups_.push_back(std::move(group));
    }
}

std::size_t JointGroups::bytes() const {
    std::size_t bytes = groups_.capacity() * sizeof(Group) +
                        (is_direct_.capacity() + may_be_direct_.capacity() + is_lone_.capacity()) / 8;
    for (const Group& group : groups_)
        bytes += (group.joints.capacity() + group.bodies.capacity()) * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace tumble
