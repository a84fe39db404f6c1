// What frames show of bodies beside their shapes: the paths of those with a trail, and the skins of soft bodies.
#pragma once

#include <span>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/style/palette.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

// Appends the trails in the colours of their bodies, also of destroyed ones.
void add_trails(Layer& layer, const View& view, const Scene& scene, const SceneWorld& world,
                std::span<const Trail> trails, const Palette& palette);

// Appends the area inside the loop through the copies of each body with a skin, and its edge, as wide as the copies.
// A body of which a copy is destroyed has none.
void add_skins(Layer& layer, const View& view, const Scene& scene, const SceneWorld& world, const Palette& palette);

// The copies of those bodies, also of skins that are not drawn.
std::vector<BodyId> bodies_with_skin(const Scene& scene, const SceneWorld& world);

// Whether the joint is a spring or a rod between the bodies of a skin, or from one to a body inside.
bool is_below_skin(const World& world, JointId joint, std::span<const BodyId> skinned);

}  // namespace tumble::render
