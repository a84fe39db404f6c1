// Highlights in a frame: outlined regions and bodies, and arrows towards those that are out of view.
#pragma once

#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

// Destroyed bodies are skipped.
void add_marking(Layer& layer, const View& view, const World& world, const Marking& marking,
                 const Colors& colors = colors_of(Theme::light));

}  // namespace tumble::render
