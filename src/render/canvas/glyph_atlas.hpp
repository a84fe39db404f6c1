// Text as rectangles of an atlas of glyphs, rasterised by stb_truetype when first used.
//
// A glyph covers whole pixels of the frame and is rasterised at one of four quarter-pixel shifts, so that text is crisp
// and evenly spaced. Its pixels do not depend on its position in the atlas.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "render/canvas/primitives.hpp"

namespace tumble::render {

// The first of the files that exists. Throws RenderError that lists them.
std::filesystem::path find_font(std::span<const std::filesystem::path> candidates);

// The paths of DejaVu Sans in common distributions.
std::span<const std::filesystem::path> font_candidates();

// The paths of fonts with the characters of many scripts, Chinese ones too, in common distributions.
std::span<const std::filesystem::path> wide_font_candidates();

class GlyphAtlas {
public:
    // Texels. The height doubles when the atlas is full: of a title of a frame with 4320 rows, whose em is 192 pixels,
    // it holds some 300 glyphs.
    static constexpr int kWidth = 1024, kFirstHeight = 256, kMostHeight = 8192;

    // The first of font_candidates() that exists, which is read for the first text: without one, that throws
    // RenderError.
    GlyphAtlas();

    // Characters that the font lacks come from the first of the wide fonts that exists; those that it lacks too are
    // boxes. Throws RenderError if the file is not a font.
    explicit GlyphAtlas(const std::filesystem::path& font,
                        std::span<const std::filesystem::path> wide_fonts = wide_font_candidates());
    ~GlyphAtlas();
    GlyphAtlas(const GlyphAtlas&) = delete;
    GlyphAtlas& operator=(const GlyphAtlas&) = delete;

    // Width of a line in pixels; `size` is the side of the font's em, as in CSS.
    double width(std::string_view utf8, double size) const;

    // Appends the glyphs of a line that starts at column `left` (pixels from the frame's left edge) with its baseline
    // below row `baseline` (from the top). Glyphs that do not fit into a full atlas are left out.
    void layout(std::string_view utf8, double size, double left, int baseline, int frame_width, int frame_height,
                Color color, std::vector<GlyphInstance>& out);

    const std::vector<std::uint8_t>& texels() const { return texels_; }  // [height()][kWidth], coverage
    int height() const { return static_cast<int>(texels_.size() / kWidth); }
    std::uint64_t revision() const { return revision_; }  // grows whenever the texels change

private:
    struct Font;
    struct Fonts;
    struct Glyph {
        int x = 0, y = 0, width = 0, height = 0;  // in the atlas
        int offset_x = 0, offset_y = 0;           // of the top left corner from the pen, y downwards
        bool stored = false;
    };
    using Key = std::tuple<bool, int, int, int>;  // wide font, glyph index, size in 1/16 pixels, quarter of a pixel

    Fonts& fonts() const;
    const Glyph& find_or_draw(bool is_wide, int index, double size, int quarter);
    bool find_room(Glyph& glyph);

    std::unique_ptr<Fonts> fonts_;
    std::map<Key, Glyph> glyphs_;
    std::vector<std::uint8_t> texels_;
    std::uint64_t revision_ = 1;
    int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;
};

}  // namespace tumble::render
