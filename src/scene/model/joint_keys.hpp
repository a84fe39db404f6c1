// Which keys of a joint belong to which of its types.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

struct JointKey {
    std::string_view name;
    bool is_there = false;
    std::vector<SceneJointType> types;

    bool belongs_to(SceneJointType type) const;
    std::string owners() const;  // "belongs to prismatic and wheel joints"
};

// The keys of a joint that not every type has.
std::vector<JointKey> joint_keys(const SceneJoint& joint);

}  // namespace tumble::scene
