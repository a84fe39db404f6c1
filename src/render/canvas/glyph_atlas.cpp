#include "render/canvas/glyph_atlas.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "debug/check.hpp"
#include "render/canvas/utf8.hpp"
#include "tumble/render.hpp"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace tumble::render {

std::filesystem::path find_font(std::span<const std::filesystem::path> candidates) {
    std::string tried;
    for (const std::filesystem::path& file : candidates) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file;
        tried += "\n  " + file.string();
    }
    throw RenderError("no font for the text in frames (Debian: apt install fonts-dejavu-core); looked for:" + tried);
}

std::span<const std::filesystem::path> font_candidates() {
    static const std::filesystem::path files[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",    // Debian, Ubuntu
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",  // Fedora
        "/usr/share/fonts/TTF/DejaVuSans.ttf",                // Arch
        "/usr/share/fonts/dejavu/DejaVuSans.ttf",             // Alpine
    };
    return files;
}

struct GlyphAtlas::Font {
    std::vector<std::uint8_t> data;
    stbtt_fontinfo info{};

    double scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size)); }
};

GlyphAtlas::GlyphAtlas(const std::filesystem::path& file)
    : font_(std::make_unique<Font>()), texels_(static_cast<std::size_t>(kSize) * kSize) {
    std::ifstream in(file, std::ios::binary);
    font_->data.assign(std::istreambuf_iterator<char>(in), {});
    const int offset = font_->data.empty() ? -1 : stbtt_GetFontOffsetForIndex(font_->data.data(), 0);
    if (offset < 0 || !stbtt_InitFont(&font_->info, font_->data.data(), offset))
        throw RenderError(file.string() + ": not a readable TrueType font");
}

GlyphAtlas::~GlyphAtlas() = default;

namespace {

// Calls visit(glyph index, pen in pixels from the line's start) for each character that the font has, and returns the
// line's width. Characters without a glyph, such as emoji, are skipped: the font would show boxes.
template <class Visit>
double walk_line(const stbtt_fontinfo& font, double scale, std::string_view utf8, Visit visit) {
    double pen = 0.0;
    int last = 0;
    while (!utf8.empty()) {
        const int index = stbtt_FindGlyphIndex(&font, static_cast<int>(take_code_point(utf8)));
        if (index == 0) continue;
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&font, index, &advance, &bearing);
        if (last != 0) pen += scale * stbtt_GetGlyphKernAdvance(&font, last, index);
        visit(index, pen);
        pen += scale * advance;
        last = index;
    }
    return pen;
}

}  // namespace

double GlyphAtlas::width(std::string_view utf8, double size) const {
    return walk_line(font_->info, font_->scale(size), utf8, [](int, double) {});
}

void GlyphAtlas::layout(std::string_view utf8, double size, double left, int baseline, int frame_width,
                        int frame_height, Color color, std::vector<GlyphInstance>& out) {
    walk_line(font_->info, font_->scale(size), utf8, [&](int index, double pen) {
        const int quarters = static_cast<int>(std::floor(4.0 * (left + pen) + 0.5));
        const int column = static_cast<int>(std::floor(quarters / 4.0));
        const Glyph& glyph = find_or_draw(index, size, quarters - 4 * column);
        if (!glyph.stored) return;
        GlyphInstance instance;
        instance.width = static_cast<float>(glyph.width);
        instance.height = static_cast<float>(glyph.height);
        instance.x = static_cast<float>(column + glyph.offset_x - 0.5 * frame_width);
        instance.y = static_cast<float>(0.5 * frame_height - (baseline + glyph.offset_y + glyph.height));
        instance.atlas_x = static_cast<float>(glyph.x);
        instance.atlas_y = static_cast<float>(glyph.y);
        instance.color = color;
        out.push_back(instance);
    });
}

const GlyphAtlas::Glyph& GlyphAtlas::find_or_draw(int index, double size, int quarter) {
    TUMBLE_CHECK(0 <= quarter);
    TUMBLE_CHECK(quarter < 4);
    const Key key{index, static_cast<int>(std::floor(16.0 * size + 0.5)), quarter};
    const auto [entry, is_new] = glyphs_.try_emplace(key);
    Glyph& glyph = entry->second;
    if (!is_new) return glyph;

    const float scale = static_cast<float>(font_->scale(size));
    const float shift = 0.25f * static_cast<float>(quarter);
    int right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font_->info, index, scale, scale, shift, 0.0f, &glyph.offset_x, &glyph.offset_y,
                                    &right, &bottom);
    glyph.width = right - glyph.offset_x;
    glyph.height = bottom - glyph.offset_y;
    if (glyph.width <= 0 || glyph.height <= 0) return glyph;  // a space

    // Glyphs are packed in rows, each as high as its highest glyph. Texts use few sizes, so that little is wasted.
    if (shelf_x_ + glyph.width > kSize) {
        shelf_x_ = 0;
        shelf_y_ += shelf_height_;
        shelf_height_ = 0;
    }
    if (shelf_x_ + glyph.width > kSize || shelf_y_ + glyph.height > kSize) return glyph;
    glyph.x = shelf_x_;
    glyph.y = shelf_y_;
    glyph.stored = true;
    TUMBLE_CHECK(glyph.x + glyph.width <= kSize);
    TUMBLE_CHECK(glyph.y + glyph.height <= kSize);
    shelf_x_ += glyph.width;
    shelf_height_ = std::max(shelf_height_, glyph.height);
    unsigned char* const corner = texels_.data() + std::ptrdiff_t{glyph.y} * kSize + glyph.x;
    stbtt_MakeGlyphBitmapSubpixel(&font_->info, corner, glyph.width, glyph.height, kSize, scale, scale, shift, 0.0f,
                                  index);
    ++revision_;
    return glyph;
}

}  // namespace tumble::render
