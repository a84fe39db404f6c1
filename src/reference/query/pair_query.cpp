#include "reference/query/pair_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace tumble::reference {

namespace {

Shape core_of(const Shape& shape) {
    if (shape.radius() == 0.0f) return shape;
    std::vector<Vec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
    return Shape::from_raw(vertices, 0.0f);
}

bool is_finite(const Shape& shape, const Pose& pose) {
    const auto finite = [](float value) { return std::isfinite(value); };
    return shape.vertex_count() > 0 && std::isfinite(shape.radius()) && std::ranges::all_of(shape.x(), finite) &&
           std::ranges::all_of(shape.y(), finite) && is_finite(pose.position) && std::isfinite(pose.rotation.c) &&
           std::isfinite(pose.rotation.s);
}

double largest_coordinate(const Shape& shape, const Pose& pose) {
    double largest = std::max(std::abs(pose.position.x), std::abs(pose.position.y));
    for (int i = 0; i < shape.vertex_count(); ++i) {
        const DVec2 vertex = transform_point(pose, shape.vertex(i));
        largest = std::max({largest, std::abs(vertex.x), std::abs(vertex.y)});
    }
    return largest + shape.radius();
}

// The radius of the rotated core: the rotation may have drifted from unit length.
double core_radius(const Shape& shape, const Pose& pose) {
    double radius_sq = 0.0;
    for (int i = 0; i < shape.vertex_count(); ++i)
        radius_sq = std::max(radius_sq, length_sq(rotate(pose.rotation, DVec2(shape.vertex(i)))));
    return std::sqrt(radius_sq);
}

void append(std::string& text, double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, " %a", value);
    text += buffer;
}

void append(std::string& text, const Shape& shape, const Pose& pose) {
    text += "radius";
    append(text, shape.radius());
    text += " vertices";
    for (int i = 0; i < shape.vertex_count(); ++i) {
        append(text, shape.vertex(i).x);
        append(text, shape.vertex(i).y);
    }
    text += " position";
    append(text, pose.position.x);
    append(text, pose.position.y);
    text += " rotation";
    append(text, pose.rotation.c);
    append(text, pose.rotation.s);
}

}  // namespace

PairQuery PairQuery::without_radii() const { return {core_of(a), core_of(b), pose_a, pose_b}; }

bool is_finite(const PairQuery& query) { return is_finite(query.a, query.pose_a) && is_finite(query.b, query.pose_b); }

double largest_coordinate(const PairQuery& query) {
    return std::max(largest_coordinate(query.a, query.pose_a), largest_coordinate(query.b, query.pose_b));
}

double error_scale(const PairQuery& query) {
    return core_radius(query.a, query.pose_a) + core_radius(query.b, query.pose_b) +
           length(query.pose_b.position - query.pose_a.position);
}

double bound_scale(const PairQuery& query) {
    const auto turned = [](const Shape& shape, Rotation q) {
        const double c = q.c, s = q.s;
        return 0.5 * (1.0 + (c * c + s * s)) * shape.core_radius();
    };
    return turned(query.a, query.pose_a.rotation) + turned(query.b, query.pose_b.rotation) +
           length(query.pose_b.position - query.pose_a.position);
}

double error_unit(const PairQuery& query) {
    return 0x1p-53 * (error_scale(query) + query.a.radius() + query.b.radius());
}

std::string to_hex(const PairQuery& query) {
    std::string text = "a: ";
    append(text, query.a, query.pose_a);
    text += "; b: ";
    append(text, query.b, query.pose_b);
    return text;
}

}  // namespace tumble::reference
