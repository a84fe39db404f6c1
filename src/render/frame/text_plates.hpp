// Texts on pale plates, which keep them readable over bodies.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "render/canvas/glyph_atlas.hpp"
#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

// Frames below kSmallestTextWidth x kSmallestTextHeight have no text.
bool has_text(const View& view);

// In pixels from the frame's top left corner.
struct TextBox {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

struct TextLine {
    std::string text;
    double size = 0.0;  // pixels, as all lengths here
    Color color;
};

class Captions {
public:
    static constexpr double kPadding = 8.0;  // of a plate, pixels at 720 rows
    static constexpr double kLineGap = 3.0;  // between lines, pixels at 720 rows
    static constexpr double kLine = 1.17;    // height of a line over the font's size

    // The least View::detail() of texts: in smaller frames they keep a size that can be read, 9 px.
    static constexpr double kLeastDetail = 0.75;

    // Plates have the colour of the background.
    Captions(Layer& layer, GlyphAtlas& atlas, const View& view, Color background)
        : layer_(layer), atlas_(atlas), view_(view), background_(background) {}

    double pixels(double at_720_rows) const { return at_720_rows * std::max(view_.detail(), kLeastDetail); }

    // Text with the top left corner of its line at (left, top).
    void text(std::string_view text, double size, double left, double top, Color color);

    // The same; `top` becomes that of the next line.
    void line(const TextLine& line, double left, double& top);

    // A plate around a box.
    void plate(const TextBox& box);

    void box(const TextBox& box, double radius, Color color);

    double width(std::string_view text, double size) const { return atlas_.width(text, size); }

    // Width and height of lines below each other.
    DVec2 size_of(std::span<const TextLine> lines) const;

    // The text, cut and ended by an ellipsis if it is wider than `room`.
    std::string fitted(std::string_view text, double size, double room) const;

private:
    Layer& layer_;
    GlyphAtlas& atlas_;
    const View& view_;
    Color background_;
};

}  // namespace tumble::render
