// Drawings as images, by the canvas that draws the frames.
//
// The canvas draws the kinds of a layer in a fixed order, but a drawing is drawn in the order of its list. An element
// whose kind precedes that of the element before it therefore opens a new layer.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "debug/check.hpp"
#include "render/canvas/canvas.hpp"
#include "render/canvas/make_context.hpp"
#include "render/shapes/outline_mesh.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "tumble/drawing.hpp"
#include "tumble/render.hpp"

namespace tumble {
namespace {

using namespace render;

double signed_area(const std::vector<DVec2>& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return 0.5 * twice;
}

// For a simple polygon, counter-clockwise.
bool is_convex(const std::vector<DVec2>& polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        const DVec2 here = polygon[i], next = polygon[(i + 1) % count], after = polygon[(i + 2) % count];
        if (cross(next - here, after - next) < 0.0) return false;
    }
    return true;
}

class LayerStack {
public:
    LayerStack(const Drawing& drawing, GlyphAtlas& atlas)
        : width_(drawing.width), height_(drawing.height), atlas_(atlas) {}

    void add(const DrawnLine& line) {
        if (line.width <= 0.0) return;
        layer(Kind::box, 0.0)
            .boxes.push_back(make_line(to_canvas(line.from), to_canvas(line.to), line.width, line.color));
    }

    void add(const DrawnPolygon& polygon) {
        std::vector<DVec2> points;
        for (const DVec2 point : polygon.points) points.push_back(to_canvas(point));
        points = thinned(points);
        if (points.empty()) return;
        if (signed_area(points) < 0.0) std::reverse(points.begin(), points.end());
        if (polygon.fill.a != 0) fill(points, polygon.fill);
        if (polygon.outline_width > 0.0) stroke(points, polygon.outline_width, polygon.outline);
    }

    void add(const DrawnDisc& disc) {
        const DVec2 center = to_canvas(disc.center);
        const bool has_outline = disc.outline_width > 0.0;
        // Outlines of a drawing straddle the edge; the canvas draws them inside it.
        const double radius = disc.radius + (has_outline ? 0.5 * disc.outline_width : 0.0);
        layer(Kind::circle, disc.outline_width)
            .circles.push_back({static_cast<float>(center.x),
                                static_cast<float>(center.y),
                                static_cast<float>(radius),
                                {disc.fill, has_outline ? disc.outline : disc.fill}});
    }

    void add(const DrawnText& text) {
        const double shift = text.anchor == TextAnchor::left ? 0.0 : text.anchor == TextAnchor::middle ? 0.5 : 1.0;
        const double left = text.at.x - shift * atlas_.width(text.text, text.size);
        atlas_.layout(text.text, text.size, left, static_cast<int>(std::floor(text.at.y + 0.5)), width_, height_,
                      text.color, layer(Kind::glyph, 0.0).glyphs);
    }

    std::vector<const Layer*> layers() const {
        std::vector<const Layer*> result;
        for (const Layer& layer : layers_) result.push_back(&layer);
        return result;
    }

private:
    enum class Kind { mesh, box, circle, glyph };  // in the order in which the canvas draws a layer

    DVec2 to_canvas(DVec2 p) const { return {p.x - 0.5 * width_, 0.5 * height_ - p.y}; }

    Layer& layer(Kind kind, double outline_width) {
        if (layers_.empty() || kind < last_kind_ || layers_.back().outline_width != outline_width) {
            layers_.emplace_back();
            layers_.back().outline_width = outline_width;
        }
        last_kind_ = kind;
        TUMBLE_CHECK(layers_.back().outline_width == outline_width);
        return layers_.back();
    }

    void stroke(const std::vector<DVec2>& points, double width, Color color) {
        TUMBLE_CHECK(width > 0.0);
        for (std::size_t i = 0; i < points.size(); ++i)
            layer(Kind::box, 0.0).boxes.push_back(make_line(points[i], points[(i + 1) % points.size()], width, color));
    }

    void fill(const std::vector<DVec2>& points, Color color) {
        if (points.size() < 3) return;
        if (is_convex(points)) return add_convex_mesh(layer(Kind::mesh, 0.0).mesh, points, 0.0, flat(color));
        // Blended edges would leave seams between the pieces. They are drawn unblended, and a hairline smooths the
        // outline.
        constexpr float kInside = -1e3f;
        constexpr double kHairline = 1.0;
        for (const Shape& piece : make_shapes(OutlineGeometry{points})) {
            const auto vertex = [&](int i) {
                return MeshVertex{piece.vertex(i).x, piece.vertex(i).y, kInside, flat(color)};
            };
            std::vector<MeshVertex>& mesh = layer(Kind::mesh, 0.0).mesh;
            for (int i = 1; i + 1 < piece.vertex_count(); ++i)
                for (const int corner : {0, i, i + 1}) mesh.push_back(vertex(corner));
        }
        stroke(points, kHairline, color);
    }

    int width_;
    int height_;
    GlyphAtlas& atlas_;
    std::vector<Layer> layers_;
    Kind last_kind_ = Kind::mesh;
};

}  // namespace

Image draw_image(const Drawing& drawing, RenderBackend backend) {
    if (drawing.width < 1 || drawing.height < 1 || drawing.width > kLargestFrame || drawing.height > kLargestFrame)
        throw std::invalid_argument("a drawing must be 1 to " + std::to_string(kLargestFrame) +
                                    " pixels wide and high, got " + std::to_string(drawing.width) + "x" +
                                    std::to_string(drawing.height));
    GlyphAtlas atlas;
    LayerStack stack(drawing, atlas);
    for (const DrawnElement& element : drawing.elements)
        std::visit([&](const auto& value) { stack.add(value); }, element);
    Image image;
    Canvas canvas(make_context(backend), drawing.width, drawing.height);
    canvas.draw(drawing.background, stack.layers(), atlas, image);
    return image;
}

}  // namespace tumble
