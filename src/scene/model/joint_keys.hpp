// Which keys of a joint belong to which of its types.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

struct JointKey {
    std::string_view name;
    bool is_present = false;
    std::vector<SceneJointType> types;

    bool belongs_to(SceneJointType type) const;
    std::string owners() const;  // "belongs to prismatic and wheel joints"
};

// All keys that some types of joints do not have; `is_present` for those of this joint.
std::vector<JointKey> joint_keys(const SceneJoint& joint);

}  // namespace tumble::scene
