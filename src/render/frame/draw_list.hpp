// Builds the draw list of a world: every primitive with its pixels and colours. No GL, no text.
#pragma once

#include <span>

#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Replaces the list by the present state of the world: grid, static bodies with their hatching, shadows, sensors, all
// other bodies, orientation marks and joints, each in the order of SceneWorld. Destroyed bodies are skipped. Bodies and
// joints of the world that the scene does not have follow, with the colours of a world without a scene. Trails lie
// below the bodies, skins above them.
void build_draw_list(DrawList& list, const Scene& scene, const SceneWorld& world, const View& view,
                     std::span<const Trail> trails = {}, const Look& look = Look());

// The same for a world without a scene: colours follow from the types and ids of its bodies.
void build_draw_list(DrawList& list, const World& world, const View& view, const Look& look = Look());

}  // namespace tumble::render
