// The value of a compiled expression in a state of the world. Nothing is kept from state to state.
#pragma once

#include <span>
#include <string>

#include "scene/expressions/program.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// As the members of Expression with these names.
double value_of(const Program& program, const SceneWorld& built);
double value_of(const Program& program, const SceneWorld& built, const World& world, std::span<const double> values);
bool holds(const Program& program, const SceneWorld& built);
double shortfall_of(const Program& program, const SceneWorld& built);
std::string finding_of(const Program& program, const SceneWorld& built);

}  // namespace tumble::scene
