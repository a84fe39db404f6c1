// A factory call for each kind of shape. Refuses what the factories accept but has no extent in float.
#include "scene/model/geometry.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/json/json_text.hpp"
#include "scene/model/degrees.hpp"
#include "tumble/outline.hpp"

namespace tumble {

namespace scene {

namespace {

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

std::string text(DVec2 v) { return compact_text(Json::array({v.x, v.y})); }

std::vector<Vec2> to_float_points(const std::vector<DVec2>& points) {
    std::vector<Vec2> result;
    for (const DVec2 point : points) result.push_back(to_float(point));
    return result;
}

void require_distinct(Vec2 from, Vec2 to, const std::string& what, DVec2 given) {
    if (from == to) refuse(what + " are the same point, " + text(given));
}

// A radius that is positive in the file must not round to 0.
float radius_of(double radius) {
    const float rounded = static_cast<float>(radius);
    if (radius > 0.0 && rounded == 0.0f) refuse("the radius " + number_text(radius) + " is too small");
    return rounded;
}

struct ShapeMaker {
    std::vector<Shape> operator()(const CircleGeometry& circle) const {
        return {make_circle(radius_of(circle.radius), to_float(circle.center))};
    }

    std::vector<Shape> operator()(const CapsuleGeometry& capsule) const {
        return {make_capsule(to_float(capsule.from), to_float(capsule.to), radius_of(capsule.radius))};
    }

    std::vector<Shape> operator()(const BoxGeometry& box) const {
        const double half_side = 0.5 * std::min(box.size.x, box.size.y);
        if (box.radius > half_side)
            refuse("the radius " + number_text(box.radius) + " is more than half the smaller side of " +
                   text(box.size));
        return {make_box(to_float(box.size), radius_of(box.radius), to_float(box.center), box.angle * kRadians)};
    }

    std::vector<Shape> operator()(const PolygonGeometry& polygon) const { return {make_hull(polygon, nullptr)}; }

    std::vector<Shape> operator()(const SegmentGeometry& segment) const {
        const Vec2 from = to_float(segment.from), to = to_float(segment.to);
        require_distinct(from, to, "'from' and 'to'", segment.from);
        return {make_segment(from, to)};
    }

    std::vector<Shape> operator()(const ChainGeometry& chain) const {
        const std::vector<Vec2> points = to_float_points(chain.points);
        for (std::size_t i = 0; i + (chain.loop ? 0 : 1) < points.size(); ++i) {
            const std::size_t next = (i + 1) % points.size();
            require_distinct(points[i], points[next],
                             "the points " + std::to_string(i) + " and " + std::to_string(next) + " of the chain",
                             chain.points[i]);
        }
        return make_chain(points, chain.loop);
    }

    std::vector<Shape> operator()(const OutlineGeometry& outline) const {
        return decompose_outline(to_float_points(outline.points));
    }
};

}  // namespace

Shape make_hull(const PolygonGeometry& polygon, HullReport* report) {
    Shape hull = make_polygon(to_float_points(polygon.vertices), radius_of(polygon.radius), report);
    if (hull.vertex_count() < 3)
        refuse("the " + std::to_string(polygon.vertices.size()) + " vertices lie on a line: they span no area");
    return hull;
}

const SceneMaterial* find_material(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [&](const SceneMaterial& material) { return material.name == name; });
    return found == scene.materials.end() ? nullptr : &*found;
}

SurfaceMaterial make_surface(const SceneMaterial& material) {
    return {static_cast<float>(material.density), static_cast<float>(material.friction),
            static_cast<float>(material.restitution), static_cast<float>(material.rolling_resistance),
            static_cast<float>(material.tangent_speed)};
}

}  // namespace scene

std::vector<Shape> make_shapes(const ShapeGeometry& geometry) { return std::visit(scene::ShapeMaker{}, geometry); }

std::vector<Shape> make_exact_shapes(const ShapeGeometry& geometry) {
    const auto* polygon = std::get_if<PolygonGeometry>(&geometry);
    if (!polygon) return make_shapes(geometry);
    return {make_exact_polygon(scene::to_float_points(polygon->vertices), scene::radius_of(polygon->radius))};
}

}  // namespace tumble
