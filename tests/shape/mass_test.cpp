#include <doctest/doctest.h>

#include <array>
#include <random>

#include "support/near.hpp"
#include "tumble/shape.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Numeric quadrature over a grid of cells: independent of the closed forms, error about perimeter x cell.
MassProperties by_quadrature(const Shape& shape, double from, double to, int cells) {
    const double h = (to - from) / cells;
    const auto inside = [&](DVec2 p) {
        double outside_sq = 1e300;
        bool in_core = shape.vertex_count() > 2;
        for (int i = 0; i < shape.vertex_count(); ++i) {
            const DVec2 a(shape.vertex(i)), e = DVec2(shape.vertex((i + 1) % shape.vertex_count())) - a, d = p - a;
            if (cross(e, d) < 0.0) in_core = false;
            const double ee = dot(e, e), t = ee > 0 ? std::min(1.0, std::max(0.0, dot(d, e) / ee)) : 0.0;
            outside_sq = std::min(outside_sq, length_sq(d - t * e));
        }
        return in_core || outside_sq <= static_cast<double>(shape.radius()) * shape.radius();
    };
    double area = 0.0, second = 0.0;
    DVec2 first;
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const DVec2 p(from + (column + 0.5) * h, from + (row + 0.5) * h);
            if (!inside(p)) continue;
            area += h * h;
            first += h * h * p;
            second += h * h * length_sq(p);
        }
    const DVec2 center = (1.0 / area) * first;
    return {area, to_float(center), second - area * length_sq(center)};
}

}  // namespace

TEST_CASE("a circle has the area pi r^2 and the inertia pi r^4 / 2 about its center") {
    const MassProperties mass = mass_properties(make_circle(2, {5, -3}));
    CHECK(near(mass.area, 4.0 * kPi, kDouble));
    CHECK(near(mass.inertia, 8.0 * kPi, kDouble));
    CHECK(mass.center == Vec2{5, -3});
}

TEST_CASE("a box has the area w h and the inertia w h (w^2 + h^2) / 12, at any position") {
    // 3 x 2 at (1000, -500): 6 and 6 * 13 / 12 = 6.5
    const MassProperties mass = mass_properties(make_box({3, 2}, 0, {1000, -500}));
    CHECK(near(mass.area, 6.0, kDouble));
    CHECK(near(mass.inertia, 6.5, kDouble));
    CHECK(mass.center == Vec2{1000, -500});
}

TEST_CASE("a right triangle has its centroid at a third of its legs") {
    // Legs 3 and 6: area 9, centroid (1, 2), I = A (a^2 + b^2) / 18 = 9 * 45 / 18 = 22.5
    const MassProperties mass = mass_properties(make_polygon(std::array<Vec2, 3>{{{0, 0}, {3, 0}, {0, 6}}}));
    CHECK(near(mass.area, 9.0, kDouble));
    CHECK(near(mass.inertia, 22.5, kDouble));
    CHECK(near(mass.center.x, 1.0, kDouble));
    CHECK(near(mass.center.y, 2.0, kDouble));
}

TEST_CASE("a capsule has the area and the inertia of a rectangle and two half discs") {
    // Length 4, radius 1 along x. Rectangle 4 x 2: area 8, I = 8 (16 + 4) / 12 = 40 / 3. Half disc: area pi / 2, its
    // centroid 4 / (3 pi) beyond the end; about the end pi / 4, about its centroid less A c^2, about the middle plus A
    // (2 + c)^2.
    const double c = 4.0 / (3.0 * kPi), half = kPi / 2.0;
    const double ends = 2.0 * (kPi / 4.0 - half * c * c + half * (2.0 + c) * (2.0 + c));
    const MassProperties mass = mass_properties(make_capsule({-2, 7}, {2, 7}, 1));
    CHECK(near(mass.area, 8.0 + kPi, kDouble));
    CHECK(near(mass.inertia, 40.0 / 3.0 + ends, kDouble));
    CHECK(mass.center == Vec2{0, 7});
}

TEST_CASE("points and segments have no mass and lie in the middle") {
    CHECK(mass_properties(make_segment({0, 0}, {2, 4})).area == 0.0);
    CHECK(mass_properties(make_segment({0, 0}, {2, 4})).center == Vec2{1, 2});
    CHECK(mass_properties(make_circle(0, {3, 1})).center == Vec2{3, 1});
    CHECK(mass_properties(make_circle(0, {3, 1})).inertia == 0.0);
    CHECK(mass_properties(Shape{}).area == 0.0);
}

TEST_CASE("rounded polygons agree with numeric quadrature") {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    for (int sample = 0; sample < 4; ++sample) {
        std::vector<Vec2> points;
        for (int i = 0; i < 6; ++i) points.push_back({coordinate(random), coordinate(random)});
        for (const float radius : {0.0f, 0.3f, 1.0f}) {
            const Shape shape = make_polygon(points, radius);
            const MassProperties exact = mass_properties(shape), numeric = by_quadrature(shape, -2.1, 2.1, 1200);
            // A grid of cell h = 0.0035 misses about sqrt(perimeter / h) cells at random, 34 of 68 000 for the smallest
            // of these shapes. At the edge, they count twice in the inertia.
            CHECK(near(exact.area, numeric.area, relative(5e-4)));
            CHECK(near(exact.inertia, numeric.inertia, relative(1e-3)));
            CHECK(std::abs(exact.center.x - numeric.center.x) < 1e-3f);
            CHECK(std::abs(exact.center.y - numeric.center.y) < 1e-3f);
        }
    }
}

TEST_CASE("duplicate and collinear vertices do not change the mass") {
    const Shape plain = make_box({2, 2}, 0.25f);
    const Shape padded = Shape::from_raw(std::array<Vec2, 7>{{{-0.75f, -0.75f},
                                                              {-0.75f, -0.75f},
                                                              {0, -0.75f},
                                                              {0.75f, -0.75f},
                                                              {0.75f, 0.75f},
                                                              {-0.75f, 0.75f},
                                                              {-0.75f, -0.75f}}},
                                         0.25f);
    CHECK(near(mass_properties(padded).area, mass_properties(plain).area, kDouble));
    CHECK(near(mass_properties(padded).inertia, mass_properties(plain).inertia, kDouble));
}
