// The text of a frame: the scene's name, the time, a caption, a scale bar, and the legend of an overlay.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/canvas/glyph_atlas.hpp"
#include "render/canvas/primitives.hpp"
#include "render/frame/overlay.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

struct FrameText {
    std::string_view title;
    double time = 0.0;  // s
    std::span<const std::string> caption;
    std::vector<LegendLine> legend;
    bool has_title = true, has_time = true, has_scale_bar = true;
};

// Appends the text and plates behind it, if the frame has text.
void add_captions(DrawList& list, GlyphAtlas& atlas, const View& view, const FrameText& text, const Colors& colors);

}  // namespace tumble::render
