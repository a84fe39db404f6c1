// What people read of a world: names and numbers.
#pragma once

#include <string>

#include "tumble/scene_world.hpp"

namespace tumble::scene {

// Names as in output, in quotes if they are its own: "'crate[3]'", "body[7]".
std::string display_name(const SceneWorld& built, std::size_t body);
std::string display_joint_name(const SceneWorld& built, std::size_t joint);
std::string display_name(const SceneWorld& built, BodyId id);

// Three digits are enough to read, and do not pretend more.
std::string brief(double value);
std::string brief(DVec2 point);  // "[1.5, -2]"

}  // namespace tumble::scene
