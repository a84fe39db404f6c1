// What a frame points at: regions, and bodies, in view or out of it.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

// Bodies that are gone are left out.
void add_marking(Layer& layer, const View& view, const World& world, const Marking& marking);

}  // namespace tumble::render
