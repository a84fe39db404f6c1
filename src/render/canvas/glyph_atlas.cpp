#include "render/canvas/glyph_atlas.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

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
    throw RenderError(
        "no font for the text in frames (Debian: apt install fonts-dejavu-core; frames without text need none); looked "
        "for:" +
        tried);
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

std::span<const std::filesystem::path> wide_font_candidates() {
    static const std::filesystem::path files[] = {
        "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",               // Debian: fonts-noto-cjk
        "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",            // Debian: fonts-droid-fallback
        "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",                       // Debian: fonts-wqy-microhei
        "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc",                         // Debian: fonts-wqy-zenhei
        "/usr/share/fonts/opentype/unifont/unifont.otf",                        // Debian: fonts-unifont
        "/usr/share/fonts/truetype/unifont/unifont.ttf",                        // Ubuntu
        "/usr/share/fonts/google-noto-sans-cjk-fonts/NotoSansCJK-Regular.ttc",  // Fedora
        "/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc",                    // Arch
    };
    return files;
}

struct GlyphAtlas::Font {
    std::vector<std::uint8_t> data;
    stbtt_fontinfo info{};

    double scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size)); }

    bool read(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        data.assign(std::istreambuf_iterator<char>(in), {});
        const int offset = data.empty() ? -1 : stbtt_GetFontOffsetForIndex(data.data(), 0);
        return offset >= 0 && stbtt_InitFont(&info, data.data(), offset);
    }
};

// The font, and the wide one, which is read when a character needs it first.
struct GlyphAtlas::Fonts {
    Font main;
    bool is_read = false;
    std::vector<std::filesystem::path> wide_files;
    std::unique_ptr<Font> wide{};
    bool has_looked = false;

    void read(const std::filesystem::path& file) {
        if (!main.read(file)) throw RenderError(file.string() + ": not a readable TrueType font");
        is_read = true;
    }

    const Font& get(bool is_wide) const { return is_wide ? *wide : main; }

    // The font of a character, and the index of its glyph there; 0 is a box.
    std::pair<bool, int> find(int code_point) {
        if (const int index = stbtt_FindGlyphIndex(&main.info, code_point); index != 0) return {false, index};
        if (!has_looked) look_for_wide_font();
        const int index = wide ? stbtt_FindGlyphIndex(&wide->info, code_point) : 0;
        return {index != 0, index};
    }

    void look_for_wide_font() {
        has_looked = true;
        for (const std::filesystem::path& file : wide_files) {
            wide = std::make_unique<Font>();
            if (wide->read(file)) return;
        }
        wide.reset();
    }
};

GlyphAtlas::GlyphAtlas() : fonts_(std::make_unique<Fonts>()), texels_(std::size_t{kFirstHeight} * kWidth) {
    const std::span<const std::filesystem::path> wide_fonts = wide_font_candidates();
    fonts_->wide_files.assign(wide_fonts.begin(), wide_fonts.end());
}

GlyphAtlas::GlyphAtlas(const std::filesystem::path& file, std::span<const std::filesystem::path> wide_fonts)
    : GlyphAtlas() {
    fonts_->wide_files.assign(wide_fonts.begin(), wide_fonts.end());
    fonts_->read(file);
}

GlyphAtlas::Fonts& GlyphAtlas::fonts() const {
    if (!fonts_->is_read) fonts_->read(find_font(font_candidates()));
    return *fonts_;
}

GlyphAtlas::~GlyphAtlas() = default;

namespace {

// Control characters, joiners and variation selectors show nothing of their own.
bool is_invisible(int code_point) {
    return code_point < 0x20 || code_point == 0x200d || (code_point >= 0xfe00 && code_point <= 0xfe0f);
}

// Calls visit(whether the font is the wide one, glyph index, pen in pixels from the line's start) for each character,
// and returns the line's width.
template <class Fonts, class Visit>
double walk_line(Fonts& fonts, double size, std::string_view utf8, Visit visit) {
    double pen = 0.0;
    int last = 0;  // glyph of the main font before, for kerning
    while (!utf8.empty()) {
        const int code_point = static_cast<int>(take_code_point(utf8));
        if (is_invisible(code_point)) continue;
        const auto [is_wide, index] = fonts.find(code_point);
        const auto& font = fonts.get(is_wide);
        const double scale = font.scale(size);
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&font.info, index, &advance, &bearing);
        if (last != 0 && !is_wide) pen += scale * stbtt_GetGlyphKernAdvance(&font.info, last, index);
        visit(is_wide, index, pen);
        pen += scale * advance;
        last = is_wide ? 0 : index;
    }
    return pen;
}

}  // namespace

double GlyphAtlas::width(std::string_view utf8, double size) const {
    return walk_line(fonts(), size, utf8, [](bool, int, double) {});
}

void GlyphAtlas::layout(std::string_view utf8, double size, double left, int baseline, int frame_width,
                        int frame_height, Color color, std::vector<GlyphInstance>& out) {
    walk_line(fonts(), size, utf8, [&](bool is_wide, int index, double pen) {
        const int quarters = static_cast<int>(std::floor(4.0 * (left + pen) + 0.5));
        const int column = static_cast<int>(std::floor(quarters / 4.0));
        const Glyph& glyph = find_or_draw(is_wide, index, size, quarters - 4 * column);
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

const GlyphAtlas::Glyph& GlyphAtlas::find_or_draw(bool is_wide, int index, double size, int quarter) {
    TUMBLE_CHECK(0 <= quarter);
    TUMBLE_CHECK(quarter < 4);
    const Key key{is_wide, index, static_cast<int>(std::floor(16.0 * size + 0.5)), quarter};
    const auto [entry, is_new] = glyphs_.try_emplace(key);
    Glyph& glyph = entry->second;
    if (!is_new) return glyph;

    const Font& font = fonts_->get(is_wide);
    const float scale = static_cast<float>(font.scale(size));
    const float shift = 0.25f * static_cast<float>(quarter);
    int right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font.info, index, scale, scale, shift, 0.0f, &glyph.offset_x, &glyph.offset_y,
                                    &right, &bottom);
    glyph.width = right - glyph.offset_x;
    glyph.height = bottom - glyph.offset_y;
    if (glyph.width <= 0 || glyph.height <= 0) return glyph;  // a space

    if (!find_room(glyph)) return glyph;
    unsigned char* const corner = texels_.data() + std::ptrdiff_t{glyph.y} * kWidth + glyph.x;
    stbtt_MakeGlyphBitmapSubpixel(&font.info, corner, glyph.width, glyph.height, kWidth, scale, scale, shift, 0.0f,
                                  index);
    ++revision_;
    return glyph;
}

// Glyphs are packed in rows, each as high as its highest glyph. Texts use few sizes, so that little is wasted.
bool GlyphAtlas::find_room(Glyph& glyph) {
    if (glyph.width > kWidth) return false;
    if (shelf_x_ + glyph.width > kWidth) {
        shelf_x_ = 0;
        shelf_y_ += shelf_height_;
        shelf_height_ = 0;
    }
    if (shelf_y_ + glyph.height > kMostHeight) return false;
    while (shelf_y_ + glyph.height > height()) texels_.resize(2 * texels_.size());
    glyph.x = shelf_x_;
    glyph.y = shelf_y_;
    glyph.stored = true;
    shelf_x_ += glyph.width;
    shelf_height_ = std::max(shelf_height_, glyph.height);
    return true;
}

}  // namespace tumble::render
