// Names and numbers for messages.
#pragma once

#include <string>

#include "tumble/scene_world.hpp"

namespace tumble::scene {

// output_name(), in quotes if it is the name in the scene file: "'crate[3]'", "body[7]".
std::string display_name(const SceneWorld& built, std::size_t body);
std::string display_joint_name(const SceneWorld& built, std::size_t joint);
std::string display_name(const SceneWorld& built, BodyId id);

// Three significant digits.
std::string brief(double value);
std::string brief(DVec2 point);  // "[1.5, -2]"

}  // namespace tumble::scene
