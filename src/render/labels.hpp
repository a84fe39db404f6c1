// The text of a frame: the scene's name, the time, a scale bar, and the legend of an overlay.
#pragma once

#include <span>
#include <string_view>

#include "render/glyph_atlas.hpp"
#include "render/overlay.hpp"
#include "render/primitives.hpp"
#include "render/view.hpp"

namespace tumble::render {

// Appends text, and the pale plates under it that keep it readable over bodies. Frames too small for it get none.
void add_labels(DrawList& list, GlyphAtlas& atlas, const View& view, std::string_view title, double time,
                std::span<const LegendLine> legend = {});

}  // namespace tumble::render
