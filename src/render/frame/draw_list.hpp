// From a scene's world to a draw list: what is drawn, where and in which colours. No GL, no text.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Replaces the list by the world as it is now: grid, static bodies, sensors, all other bodies, orientation marks and
// joints, each in the order of their ids. Bodies that were destroyed are left out.
void build_draw_list(DrawList& list, const Scene& scene, const SceneWorld& world, const View& view);

}  // namespace tumble::render
