#include "dynamics/joints/joint_groups.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tumble {

namespace {

// The most joints of a group that the direct solver takes: of any group, and of one with a heavy body.
constexpr std::size_t kSmallGroup = 4;
constexpr std::size_t kLargestGroup = 64;
// A heavy body has at least this many times the mass of the lightest body of its group.
constexpr float kHeavyBody = 10.0f;

}  // namespace

JointGroups::Group JointGroups::take_group(std::uint32_t first, std::vector<bool>& left,
                                           const std::vector<JoinedBodies>& joined, const BodyStore& bodies) {
    Group group;
    const auto take = [&](std::uint32_t joint) {
        if (!left[joint]) return;
        left[joint] = false;
        group.joints.push_back(joint);
    };
    take(first);
    for (std::size_t i = 0; i < group.joints.size(); ++i)
        for (const BodyId body : joined[group.joints[i]]) {
            group.is_held |= !bodies.is_dynamic(body.index);
            if (!bodies.is_dynamic(body.index)) continue;
            group.bodies.push_back(body.index);
            for (const JointId joint : bodies.records[body.index].joints) take(joint.index);
        }
    return group;
}

bool JointGroups::suits(const Group& group, const BodyStore& bodies) {
    // A joint alone has an exact solution of its own (rows/lone_joint.hpp).
    if (!group.is_held || group.joints.size() < 2 || group.joints.size() > kLargestGroup) return false;
    float lightest = std::numeric_limits<float>::infinity(), heaviest = 0.0f;
    for (const std::uint32_t body : group.bodies) {
        lightest = std::min(lightest, bodies.records[body].mass.mass);
        heaviest = std::max(heaviest, bodies.records[body].mass.mass);
    }
    return group.joints.size() <= kSmallGroup || heaviest >= kHeavyBody * lightest;
}

void JointGroups::find(JointSolver solver, const std::vector<JoinedBodies>& joined, const BodyStore& bodies) {
    solver_ = solver;
    groups_.clear();
    std::vector<bool> left(joined.size());
    for (std::size_t joint = 0; joint < joined.size(); ++joint) left[joint] = !joined[joint].empty();
    if (solver == JointSolver::direct) {
        is_direct_ = left;
        has_direct_ = std::find(left.begin(), left.end(), true) != left.end();
        return;
    }
    is_direct_.assign(joined.size(), false);
    for (std::uint32_t joint = 0; joint < joined.size(); ++joint) {
        if (!left[joint]) continue;
        Group group = take_group(joint, left, joined, bodies);
        if (suits(group, bodies)) groups_.push_back(std::move(group));
    }
}

std::size_t JointGroups::bytes() const {
    std::size_t bytes = groups_.capacity() * sizeof(Group) + is_direct_.capacity() / 8;
    for (const Group& group : groups_)
        bytes += (group.joints.capacity() + group.bodies.capacity()) * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace tumble
