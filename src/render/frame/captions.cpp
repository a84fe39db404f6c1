#include "render/frame/captions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "render/frame/grid.hpp"
#include "render/frame/text_plates.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

// Pixels at 720 rows.
constexpr double kScaleBar = 70.0;    // the least length of the scale bar
constexpr double kBarEnd = 6.0;       // height of the ends of the scale bar
constexpr double kLegendMark = 18.0;  // width of the marks in a legend

// Seconds with two decimals, independent of the locale.
std::string seconds(double time) {
    char text[64];
    const auto [end, error] = std::to_chars(text, text + sizeof text, time, std::chars_format::fixed, 2);
    return error == std::errc{} ? std::string(text, end) + " s" : std::string();
}

// In the upper left corner: title, time and caption, one line each.
void add_heading(Captions& captions, const View& view, const FrameText& text, const Colors& colors) {
    const double margin = captions.pixels(style::kMargin), room = view.width - 2.0 * margin;
    const double title_size = captions.pixels(style::kTitleSize), text_size = captions.pixels(style::kTextSize);
    std::vector<TextLine> lines;
    if (const std::string name = text.has_title ? captions.fitted(text.title, title_size, room) : ""; !name.empty())
        lines.push_back({name, title_size, colors.text});
    if (text.has_time) lines.push_back({seconds(text.time), text_size, colors.faint_text});
    for (const std::string& line : text.caption)
        lines.push_back({captions.fitted(line, text_size, room), text_size, colors.text});
    if (lines.empty()) return;

    const DVec2 size = captions.size_of(lines);
    captions.plate({margin, margin, size.x, size.y});
    double top = margin;
    for (const TextLine& line : lines) captions.line(line, margin, top);
}

void add_scale_bar(Captions& captions, const View& view, const Colors& colors) {
    const double margin = captions.pixels(style::kMargin), size = captions.pixels(style::kTextSize);
    const double thickness = std::max(1.0, std::floor(captions.pixels(1.5) + 0.5)), tick = captions.pixels(kBarEnd);
    const RoundLength round = round_length_from(captions.pixels(kScaleBar) / view.scale);
    const std::string text = to_string(round);
    const double length = round.metres() * view.scale, height = Captions::kLine * size;
    const TextBox area{margin, view.height - margin - height, length + tick + captions.width(text, size), height};
    captions.plate(area);

    const double bottom = std::floor(area.top + 0.5 * (height + tick));
    captions.box({area.left, bottom - thickness, length, thickness}, 0.0, colors.faint_text);
    for (const double left : {area.left, area.left + length - thickness})
        captions.box({left, bottom - tick, thickness, tick - thickness}, 0.0, colors.faint_text);
    captions.text(text, size, area.left + length + tick, area.top, colors.faint_text);
}

// In the lower right corner: one line for each kind of mark.
void add_legend(Captions& captions, const View& view, std::span<const LegendLine> lines, const Colors& colors) {
    if (lines.empty()) return;
    const double margin = captions.pixels(style::kMargin), size = captions.pixels(style::kTextSize);
    const double mark = captions.pixels(kLegendMark),
                 row = Captions::kLine * size + captions.pixels(Captions::kLineGap);
    double width = 0.0;
    for (const LegendLine& line : lines) width = std::max(width, captions.width(line.text, size));
    const double all = mark + captions.pixels(Captions::kPadding) + width,
                 height = row * static_cast<double>(lines.size());
    const TextBox area{view.width - margin - all, view.height - margin - height, all, height};
    captions.plate(area);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double top = area.top + row * static_cast<double>(i), middle = top + 0.5 * Captions::kLine * size;
        const bool is_line = lines[i].mark == LegendLine::Mark::line, is_dot = lines[i].mark == LegendLine::Mark::dot;
        const double thick = is_line ? captions.pixels(2.0) : is_dot ? captions.pixels(7.0) : 0.8 * size;
        const double wide = is_dot ? thick : mark;
        captions.box({area.left + 0.5 * (mark - wide), middle - 0.5 * thick, wide, thick}, is_dot ? 0.5 * thick : 0.0,
                     lines[i].color);
        captions.text(lines[i].text, size, area.left + mark + captions.pixels(Captions::kPadding), top, colors.text);
    }
}

}  // namespace

void add_captions(DrawList& list, GlyphAtlas& atlas, const View& view, const FrameText& text, const Colors& colors) {
    if (!has_text(view)) return;
    Captions captions(list.captions, atlas, view, colors.background);
    add_heading(captions, view, text, colors);
    if (text.has_scale_bar) add_scale_bar(captions, view, colors);
    add_legend(captions, view, text.legend, colors);
}

}  // namespace tumble::render
