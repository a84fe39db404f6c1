#include "render/frame/text_plates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "debug/check.hpp"

namespace tumble::render {
namespace {

constexpr double kPlateOpacity = 0.82;
constexpr double kAscent = 0.93;  // of DejaVu Sans over the font's size

}  // namespace

bool has_text(const View& view) { return view.width >= kSmallestTextWidth && view.height >= kSmallestTextHeight; }

void Captions::text(std::string_view text, double size, double left, double top, Color color) {
    const int baseline = static_cast<int>(std::floor(top + kAscent * size + 0.5));
    atlas_.layout(text, size, left, baseline, view_.width, view_.height, color, layer_.glyphs);
}

void Captions::line(const TextLine& line, double left, double& top) {
    text(line.text, line.size, left, top, line.color);
    top += kLine * line.size + pixels(kLineGap);
}

void Captions::plate(const TextBox& r) {
    const double pad = pixels(kPadding);
    box({r.left - pad, r.top - pad, r.width + 2.0 * pad, r.height + 2.0 * pad}, pad, faded(background_, kPlateOpacity));
}

void Captions::box(const TextBox& r, double radius, Color color) {
    TUMBLE_CHECK(2.0 * radius <= r.width);
    TUMBLE_CHECK(2.0 * radius <= r.height);
    BoxInstance box;
    box.x = static_cast<float>(r.left + 0.5 * r.width - 0.5 * view_.width);
    box.y = static_cast<float>(0.5 * view_.height - r.top - 0.5 * r.height);
    box.half_x = static_cast<float>(0.5 * r.width - radius);
    box.half_y = static_cast<float>(0.5 * r.height - radius);
    box.radius = static_cast<float>(radius);
    box.paint = flat(color);
    layer_.boxes.push_back(box);
}

DVec2 Captions::size_of(std::span<const TextLine> lines) const {
    DVec2 size{0.0, -pixels(kLineGap)};
    for (const TextLine& line : lines) {
        size.x = std::max(size.x, width(line.text, line.size));
        size.y += kLine * line.size + pixels(kLineGap);
    }
    return size;
}

std::string Captions::fitted(std::string_view of, double size, double room) const {
    if (width(of, size) <= room) return std::string(of);
    std::vector<std::size_t> ends;  // of the characters but the last
    for (std::size_t at = 1; at < of.size(); ++at)
        if ((static_cast<unsigned char>(of[at]) & 0xc0) != 0x80) ends.push_back(at);
    const auto cut = [&](std::size_t end) { return std::string(of.substr(0, end)) + "\u2026"; };
    const auto first_too_wide =
        std::ranges::partition_point(ends, [&](std::size_t end) { return width(cut(end), size) <= room; });
    return first_too_wide == ends.begin() ? "" : cut(*std::prev(first_too_wide));
}

}  // namespace tumble::render
