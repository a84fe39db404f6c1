// Builds the draw list of a world: every primitive with its pixels and colours. No GL, no text.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Replaces the list by the present state of the world: grid, static bodies, sensors, all other bodies, orientation
// marks and joints, each in the order of SceneWorld. Destroyed bodies are skipped.
void build_draw_list(DrawList& list, const Scene& scene, const SceneWorld& world, const View& view);

}  // namespace tumble::render
