// The text of a frame: the scene's name, the time, and a scale bar.
#pragma once

#include <string_view>

#include "render/glyph_atlas.hpp"
#include "render/primitives.hpp"
#include "render/view.hpp"

namespace tumble::render {

// Appends text, and the pale plates under it that keep it readable over bodies. Frames too small for it get none.
void add_labels(DrawList& list, GlyphAtlas& atlas, const View& view, std::string_view title, double time);

}  // namespace tumble::render
