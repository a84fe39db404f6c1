// Known failures of other engines, from their issue trackers, each reduced to one pair that shows the mechanism.
#include <array>
#include <cmath>
#include <vector>

#include "reference/families/pair_families.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

Shape circle(double radius, Vec2 center = {}) {
    return Shape::from_raw(std::array{center}, static_cast<float>(radius));
}

Shape capsule(Vec2 from, Vec2 to, double radius) {
    return Shape::from_raw(std::array{from, to}, static_cast<float>(radius));
}

Pose at(double x, double y, double degrees = 0.0) { return {{x, y}, make_rotation_degrees(degrees)}; }

// A regular polygon about its origin, its first vertex on the x axis.
Shape regular(int count, double radius) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < count; ++i)
        vertices.push_back(
            to_float(radius * DVec2{sin_cos(2.0 * kPi * i / count).cos, sin_cos(2.0 * kPi * i / count).sin}));
    return Shape::from_raw(vertices, 0.0f);
}

std::vector<RegressionCase> make_cases() {
    const Shape unit = box(0.5, 0.5);
    const Shape triangle = Shape::from_raw(std::array{Vec2{0.0f, 0.0f}, Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}}, 0.0f);
    std::vector<RegressionCase> cases;
    cases.push_back({"normal_at_a_tiny_distance",
                     "Box2D 917: a zero normal where the witness points coincide in float",
                     {circle(0.0), unit, at(0.25, 0.5 + 1e-9), at(0.0, 0.0)},
                     1});
    cases.push_back({"radii_just_apart",
                     "Box2D 990, 883: between touching and separated with radii",
                     {circle(0.5), circle(0.5), at(0.0, 0.0), at(1.0 + 0x1p-52, 0.0)},
                     1});
    cases.push_back({"radii_just_touching",
                     "Box2D 990, 883: exactly touching with radii",
                     {circle(0.5), circle(0.5), at(0.0, 0.0), at(1.0, 0.0)},
                     0});
    cases.push_back({"radii_just_overlapping",
                     "Box2D 990, 883: overlapping by less than float resolves",
                     {circle(0.5), circle(0.5), at(0.0, 0.0), at(1.0 - 0x1p-53, 0.0)},
                     -1});
    cases.push_back({"rounded_boxes_just_apart",
                     "Box2D 990, 883: just apart with radii, between faces",
                     {box(0.5, 0.5, 0.25), box(0.5, 0.5, 0.25), at(0.0, 0.0), at(1.5 + 0x1p-51, 0.1)},
                     1});
    cases.push_back({"small_boxes_apart",
                     "Bullet 2579: small shapes taken as touching by an absolute epsilon",
                     {box(5e-5, 5e-5), box(5e-5, 5e-5), at(0.0, 0.0), at(1.1e-4, 0.0)},
                     1});
    cases.push_back({"vertices_closer_than_1_mm",
                     "parry: vertices nearer than 1.1 mm merged",
                     {box(4e-4, 4e-4), box(4e-4, 4e-4), at(0.0, 0.0, 45.0), at(9.8e-4, 0.0)},
                     1});
    cases.push_back({"huge_against_small",
                     "parry 429: a ground of 10 km and a ball of 1 cm",
                     {box(5000.0, 1.0), circle(0.01), at(0.0, -1.0), at(1234.5, 0.0101)},
                     1});
    cases.push_back({"false_separation",
                     "openGJK 3, 13: a corner inside by 1e-6",
                     {unit, box(0.5, 0.5), at(0.0, 0.0, 30.0), at(0.5 + 0.68301270 - 1e-6, 0.0)},
                     -1});
    cases.push_back({"false_separation_triangle",
                     "openGJK 3, 13: a vertex just inside a hypotenuse",
                     {triangle, circle(0.0), at(0.0, 0.0), at(0.5, 0.4999999)},
                     -1});
    cases.push_back({"exact_zero_while_separated",
                     "MuJoCo 3383: distance 0 for shapes that are apart",
                     {unit, unit, at(0.0, 0.0, 10.0), at(1.25, 0.0, -20.0)},
                     1});
    cases.push_back({"parallel_faces",
                     "cycling between the ends of parallel faces",
                     {unit, unit, at(0.0, 0.0), at(0.3, 1.0 + 1e-7)},
                     1});
    cases.push_back({"parallel_faces_turned",
                     "cycling between the ends of parallel faces, off the axes",
                     {unit,
                      unit,
                      at(0.0, 0.0, 33.0),
                      {1.0000001 * rotate(make_rotation_degrees(33.0), DVec2{0.0, 1.0}), make_rotation_degrees(33.0)}},
                     1});
    cases.push_back({"iteration_limit",
                     "parry, FCL 366: the iteration limit reported as no intersection",
                     {regular(64, 1.0), regular(64, 1.0), at(0.0, 0.0), at(1.999, 0.0)},
                     -1});
    cases.push_back({"kissing_faces",
                     "FCL 495, parry 378: GJK and the penetration solver disagree at exact contact",
                     {unit, unit, at(0.0, 0.0), at(1.0, 0.25)},
                     0});
    cases.push_back({"kissing_vertex",
                     "FCL 495, parry 378: a vertex exactly on an edge",
                     {unit, triangle, at(0.0, 0.0), at(0.5, 0.25)},
                     0});
    cases.push_back({"twelve_gon",
                     "Box2D v3: more than 8 vertices silently clamped",
                     {regular(12, 1.0), circle(0.0), at(0.0, 0.0), at(0.0, -1.5)},
                     1});
    cases.push_back({"coincident_centres",
                     "concentric circles: no normal is distinguished",
                     {circle(0.5), circle(0.25), at(3.0, 4.0), at(3.0, 4.0)},
                     -1});
    cases.push_back({"collinear_capsules",
                     "capsules along each other: no face has a positive depth",
                     {capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.1), capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.1),
                      at(0.0, 0.0), at(0.5, 0.0)},
                     -1});
    cases.push_back({"crossed_segments",
                     "two segments that cross have a depth without having an area",
                     {capsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.0), capsule({0.0f, -1.0f}, {0.0f, 1.0f}, 0.0),
                      at(0.0, 0.0), at(0.25, 0.5)},
                     -1});
    return cases;
}

}  // namespace

std::span<const RegressionCase> regression_cases() {
    static const std::vector<RegressionCase> cases = make_cases();
    return cases;
}

}  // namespace tumble::reference
