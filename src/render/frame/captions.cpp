#include "render/frame/captions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "debug/check.hpp"
#include "render/frame/grid.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kPlateOpacity = 0.82;
constexpr double kPlatePadding = 8.0;  // pixels at 720 rows, as are all lengths below
constexpr double kLineGap = 3.0;
constexpr double kAscent = 0.93;      // of DejaVu Sans over the font's size
constexpr double kLine = 1.17;        // height of a line over the font's size
constexpr double kScaleBar = 70.0;    // the least length of the scale bar
constexpr double kBarEnd = 6.0;       // height of the ends of the scale bar
constexpr double kLegendMark = 18.0;  // width of the marks in a legend

// Lengths in pixels from the frame's top left corner.
struct Rectangle {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

// Seconds with two decimals, independent of the locale.
std::string seconds(double time) {
    char text[64];
    const auto [end, error] = std::to_chars(text, text + sizeof text, time, std::chars_format::fixed, 2);
    return error == std::errc{} ? std::string(text, end) + " s" : std::string();
}

class Captions {
public:
    Captions(DrawList& list, GlyphAtlas& atlas, const View& view) : list_(list), atlas_(atlas), view_(view) {}

    double pixels(double at_720_rows) const { return at_720_rows * view_.detail(); }

    // Text with the top left corner of its line at (left, top).
    void text(std::string_view text, double size, double left, double top, Color color) {
        const int baseline = static_cast<int>(std::floor(top + kAscent * size + 0.5));
        atlas_.layout(text, size, left, baseline, view_.width, view_.height, color, list_.captions.glyphs);
    }

    void plate(const Rectangle& r) {
        const double pad = pixels(kPlatePadding);
        box({r.left - pad, r.top - pad, r.width + 2.0 * pad, r.height + 2.0 * pad}, pad,
            faded(style::kBackground, kPlateOpacity));
    }

    void box(const Rectangle& r, double radius, Color color) {
        TUMBLE_CHECK(2.0 * radius <= r.width);
        TUMBLE_CHECK(2.0 * radius <= r.height);
        BoxInstance box;
        box.x = static_cast<float>(r.left + 0.5 * r.width - 0.5 * view_.width);
        box.y = static_cast<float>(0.5 * view_.height - r.top - 0.5 * r.height);
        box.half_x = static_cast<float>(0.5 * r.width - radius);
        box.half_y = static_cast<float>(0.5 * r.height - radius);
        box.radius = static_cast<float>(radius);
        box.paint = flat(color);
        list_.captions.boxes.push_back(box);
    }

    double width(std::string_view text, double size) const { return atlas_.width(text, size); }

private:
    DrawList& list_;
    GlyphAtlas& atlas_;
    const View& view_;
};

// The title, cut and ended by an ellipsis if it is wider than `room`.
std::string fitted(const Captions& captions, std::string_view title, double size, double room) {
    std::string text(title);
    while (!text.empty() && captions.width(text, size) > room) {
        std::size_t end = text.size();
        if (text.ends_with("\u2026")) end -= std::string_view("\u2026").size();
        while (end > 0 && (static_cast<unsigned char>(text[--end]) & 0xc0) == 0x80) continue;
        text = text.substr(0, end) + (end > 0 ? "\u2026" : "");
    }
    return text;
}

// In the upper left corner: title, time and caption, one line each.
void add_heading(Captions& captions, const View& view, const FrameText& text) {
    struct Line {
        std::string text;
        double size;
        Color color;
    };
    const double margin = captions.pixels(style::kMargin), room = view.width - 2.0 * margin;
    const double title_size = captions.pixels(style::kTitleSize), text_size = captions.pixels(style::kTextSize);
    std::vector<Line> lines;
    if (const std::string name = text.has_title ? fitted(captions, text.title, title_size, room) : ""; !name.empty())
        lines.push_back({name, title_size, style::kText});
    if (text.has_time) lines.push_back({seconds(text.time), text_size, style::kFaintText});
    for (const std::string& line : text.caption)
        lines.push_back({fitted(captions, line, text_size, room), text_size, style::kText});
    if (lines.empty()) return;

    double width = 0.0, height = -captions.pixels(kLineGap);
    for (const Line& line : lines) {
        width = std::max(width, captions.width(line.text, line.size));
        height += kLine * line.size + captions.pixels(kLineGap);
    }
    captions.plate({margin, margin, width, height});
    double top = margin;
    for (const Line& line : lines) {
        captions.text(line.text, line.size, margin, top, line.color);
        top += kLine * line.size + captions.pixels(kLineGap);
    }
}

void add_scale_bar(Captions& captions, const View& view) {
    const double margin = captions.pixels(style::kMargin), size = captions.pixels(style::kTextSize);
    const double thickness = std::max(1.0, std::floor(captions.pixels(1.5) + 0.5)), tick = captions.pixels(kBarEnd);
    const RoundLength round = round_length_from(captions.pixels(kScaleBar) / view.scale);
    const std::string text = to_string(round);
    const double length = round.metres() * view.scale, height = kLine * size;
    const Rectangle area{margin, view.height - margin - height, length + tick + captions.width(text, size), height};
    captions.plate(area);

    const double bottom = std::floor(area.top + 0.5 * (height + tick));
    captions.box({area.left, bottom - thickness, length, thickness}, 0.0, style::kFaintText);
    for (const double left : {area.left, area.left + length - thickness})
        captions.box({left, bottom - tick, thickness, tick - thickness}, 0.0, style::kFaintText);
    captions.text(text, size, area.left + length + tick, area.top, style::kFaintText);
}

// In the lower right corner: one line for each kind of mark.
void add_legend(Captions& captions, const View& view, std::span<const LegendLine> lines) {
    if (lines.empty()) return;
    const double margin = captions.pixels(style::kMargin), size = captions.pixels(style::kTextSize);
    const double mark = captions.pixels(kLegendMark), row = kLine * size + captions.pixels(kLineGap);
    double width = 0.0;
    for (const LegendLine& line : lines) width = std::max(width, captions.width(line.text, size));
    const double all = mark + captions.pixels(kPlatePadding) + width, height = row * static_cast<double>(lines.size());
    const Rectangle area{view.width - margin - all, view.height - margin - height, all, height};
    captions.plate(area);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double top = area.top + row * static_cast<double>(i), middle = top + 0.5 * kLine * size;
        const bool is_line = lines[i].mark == LegendLine::Mark::line, is_dot = lines[i].mark == LegendLine::Mark::dot;
        const double thick = is_line ? captions.pixels(2.0) : is_dot ? captions.pixels(7.0) : 0.8 * size;
        const double wide = is_dot ? thick : mark;
        captions.box({area.left + 0.5 * (mark - wide), middle - 0.5 * thick, wide, thick}, is_dot ? 0.5 * thick : 0.0,
                     lines[i].color);
        captions.text(lines[i].text, size, area.left + mark + captions.pixels(kPlatePadding), top, style::kText);
    }
}

}  // namespace

void add_captions(DrawList& list, GlyphAtlas& atlas, const View& view, const FrameText& text) {
    if (view.width < kSmallestTextWidth || view.height < kSmallestTextHeight) return;
    Captions captions(list, atlas, view);
    add_heading(captions, view, text);
    if (text.has_scale_bar) add_scale_bar(captions, view);
    add_legend(captions, view, text.legend);
}

}  // namespace tumble::render
