#include "render/drawing/pair_drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "debug/check.hpp"
namespace tumble {

namespace render {

namespace {

void draw_shape(Panel& panel, const std::vector<DVec2>& outline, const std::vector<DVec2>& core, double radius,
                Color fill, Color line) {
    panel.fill(outline, fill, 2.0, line);
    if (radius > 0.0) panel.fill(core, kTransparent, 1.0, line);
}

// Draws the letter in the middle of the shape, offset a little away from the contact.
void draw_letter(Panel& panel, const std::vector<DVec2>& outline, DVec2 contact, const char* letter, Color color) {
    const auto farther = [contact](DVec2 p, DVec2 q) { return length_sq(p - contact) < length_sq(q - contact); };
    const DVec2 middle = mean(outline), farthest = *std::ranges::max_element(outline, farther);
    panel.label(middle + 0.3 * (farthest - middle), {0.0, 7.0}, letter, 20.0, color);
}

}  // namespace

double PairDrawing::smaller_extent() const { return std::min(extent(a_).larger, extent(b_).larger); }

std::vector<DVec2> PairDrawing::outline_a(double radius) const {
    return sampled_outline([this](DVec2 d) { return support_a(d); }, radius);
}

std::vector<DVec2> PairDrawing::outline_b(double radius) const {
    return sampled_outline([this](DVec2 d) { return support_b(d); }, radius);
}

std::vector<DVec2> PairDrawing::outline_difference(double radius) const {
    return sampled_outline([this](DVec2 d) { return support_a(d) - support_b(-d); }, radius);
}

void PairDrawing::draw(Panel& panel, const DistanceResult& result) const {
    const std::vector<DVec2> a = outline_a(a_.radius()), b = outline_b(b_.radius());
    draw_shape(panel, a, outline_a(0.0), a_.radius(), ink::kShapeAFill, ink::kShapeA);
    draw_shape(panel, b, outline_b(0.0), b_.radius(), ink::kShapeBFill, ink::kShapeB);
    const bool is_valid = result.status != DistanceStatus::invalid;
    const DVec2 point_a = is_valid ? from_world(result.point_a) : DVec2{};
    const DVec2 point_b = is_valid ? from_world(result.point_b) : DVec2{};
    draw_letter(panel, a, 0.5 * (point_a + point_b), "A", ink::kShapeA);
    draw_letter(panel, b, 0.5 * (point_a + point_b), "B", ink::kShapeB);
    if (!is_valid) return;
    panel.line(point_a, point_b, 2.0, ink::kAnswer);
    panel.arrow(point_a, result.normal, 30.0, ink::kAnswer);
    panel.dot(point_a, 4.5, ink::kShapeA);
    panel.dot(point_b, 4.5, ink::kShapeB);
}

void draw_pair_panel(Drawing& drawing, PixelRect rect, const PairDrawing& pair, const DistanceResult& result) {
    std::vector<DVec2> all = pair.outline_a(0.0);
    for (const std::vector<DVec2>& outline :
         {pair.outline_b(0.0), pair.outline_b(pair.radii()), pair.outline_a(pair.radii())})
        all.insert(all.end(), outline.begin(), outline.end());
    Panel panel(drawing, draw_frame(drawing, rect, "The shapes, with their closest (or deepest) points and the normal"),
                all);
    pair.draw(panel, result);
}

std::string short_number(double value) {
    value += 0.0;  // no negative zero
    std::array<char, 32> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 5);
    return error == std::errc() ? std::string(buffer.data(), end) : std::string("?");
}

DVec2 mean(const std::vector<DVec2>& points) {
    TUMBLE_CHECK(!points.empty());
    DVec2 sum;
    for (const DVec2 p : points) sum += p;
    return (1.0 / static_cast<double>(points.size())) * sum;
}

namespace {

// Draws the contact enlarged: a few times the distance wide, at least a thousandth of the smaller shape.
void draw_contact_panel(Drawing& drawing, PixelRect rect, const PairDrawing& pair, const DistanceResult& result,
                        std::span<const DVec2> rings) {
    const double reach = std::max(4.0 * std::abs(result.distance), 1e-3 * pair.smaller_extent());
    const DVec2 middle = 0.5 * (pair.from_world(result.point_a) + pair.from_world(result.point_b));
    const std::array<DVec2, 2> corners = {middle - DVec2{reach, reach}, middle + DVec2{reach, reach}};
    Panel panel(drawing, draw_frame(drawing, rect, "At the contact, " + short_number(2.0 * reach) + " m high"),
                corners);
    pair.draw(panel, result);
    for (const DVec2 ring : rings) panel.ring(pair.from_world(ring), 8.0, ink::kText);
}

}  // namespace

}  // namespace render

Drawing draw_pair(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                  const DistanceResult& result, std::span<const DVec2> rings) {
    using namespace render;
    constexpr double kGap = 16.0, kHeight = 430.0;
    Drawing drawing;
    drawing.width = 1280;
    drawing.height = static_cast<int>(kHeight + 2.0 * kGap);
    const PairDrawing pair(a, world_from_a, b, world_from_b);
    const double half = 0.5 * (drawing.width - 3.0 * kGap);
    draw_pair_panel(drawing, {kGap, kGap, half, kHeight}, pair, result);
    if (result.status != DistanceStatus::invalid)
        draw_contact_panel(drawing, {2.0 * kGap + half, kGap, half, kHeight}, pair, result, rings);
    return drawing;
}

}  // namespace tumble
