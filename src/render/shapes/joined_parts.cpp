#include "render/shapes/joined_parts.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "render/shapes/shape_primitives.hpp"
#include "render/view/clip.hpp"

namespace tumble::render {
namespace {

// Deeper than any outline is wide (pixels).
constexpr float kInside = -1e6f;

struct Edge {
    Vec2 from, to;
    std::size_t part = 0;
};

// An edge and its reverse have the same key.
auto key_of(const Edge& edge) {
    const auto from = std::tie(edge.from.x, edge.from.y), to = std::tie(edge.to.x, edge.to.y);
    return std::pair{std::min(from, to), std::max(from, to)};
}

bool is_plain(const Shape& shape) { return shape.vertex_count() >= 3 && shape.radius() == 0.0f; }

template <class Take>
std::vector<Edge> sorted_edges(std::span<const Part> parts, Take&& take) {
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Shape& shape = *parts[k].shape;
        const int count = shape.vertex_count();
        for (int i = 0; take(parts[k]) && i < count; ++i)
            edges.push_back({shape.vertex(i), shape.vertex(i + 1 < count ? i + 1 : 0), k});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return key_of(a) < key_of(b); });
    return edges;
}

bool are_shared(const Edge& a, const Edge& b, std::span<const Part> parts) {
    return a.from == b.to && a.to == b.from && parts[a.part].paint == parts[b.part].paint;
}

void add_fan(std::vector<MeshVertex>& mesh, const View& view, const Part& part, const Pose& pose) {
    std::vector<DVec2> polygon;
    for (int i = 0; i < part.shape->vertex_count(); ++i)
        polygon.push_back(view.to_pixels(transform_point(pose, part.shape->vertex(i))));
    polygon = clip_polygon(view, kClipMargin, std::move(polygon));
    const auto corner = [&](std::size_t i) {
        return MeshVertex{static_cast<float>(polygon[i].x), static_cast<float>(polygon[i].y), kInside,
                          flat(part.paint.fill)};
    };
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) mesh.insert(mesh.end(), {corner(0), corner(i), corner(i + 1)});
}

}  // namespace

void find_joined(std::span<Part> parts) {
    if (parts.size() < 2) return;
    const std::vector<Edge> edges = sorted_edges(parts, [](const Part& part) { return is_plain(*part.shape); });
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (are_shared(edges[i - 1], edges[i], parts))
            parts[edges[i - 1].part].is_joined = parts[edges[i].part].is_joined = true;
}

void add_joined_parts(Layer& layer, const View& view, std::span<const Part> parts, const Pose& pose) {
    for (const Part& part : parts)
        if (part.is_joined) add_fan(layer.mesh, view, part, pose);
    const std::vector<Edge> edges = sorted_edges(parts, [](const Part& part) { return part.is_joined; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i + 1 < edges.size() && are_shared(edges[i], edges[i + 1], parts)) {
            ++i;
            continue;
        }
        add_line(layer, view, view.to_pixels(transform_point(pose, edges[i].from)),
                 view.to_pixels(transform_point(pose, edges[i].to)), layer.outline_width,
                 parts[edges[i].part].paint.outline);
    }
}

}  // namespace tumble::render
