#include "tumble/outline.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <array>
#include <chrono>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "support/outlines.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

Outline vertices(const Shape& part) {
    Outline ring;
    for (int i = 0; i < part.vertex_count(); ++i) ring.push_back(part.vertex(i));
    return ring;
}

std::string error_of(const Outline& outline) {
    try {
        decompose_outline(outline);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

std::string edge_error(const char* edge, const char* other) {
    return std::string("an outline must not cross or touch itself: edge ") + edge + " meets edge " + other;
}

bool is_strictly_convex(const Outline& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (side(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <= 0) return false;
    return ring.size() >= 3;
}

// Convex rings with disjoint interiors are separated by the line of an edge of one of them.
bool is_separated_by_edge_of(const Outline& ring, const Outline& other) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (std::ranges::all_of(other, [&](Vec2 p) { return side(ring[i], ring[(i + 1) % ring.size()], p) <= 0; }))
            return true;
    return false;
}

// The centroid of the part's first triangle, scaled by 3 to stay an integer, is inside the outline scaled by 3: the ray
// to the right crosses the boundary an odd number of times. Coordinates below 2^20 keep all products exact.
bool has_interior_point_inside(const Outline& part, const Outline& outline) {
    const auto thrice = [](Vec2 p) { return Vec2{3 * p.x, 3 * p.y}; };
    const Vec2 point = part[0] + part[1] + part[2];
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Vec2 a = thrice(outline[i]), b = thrice(outline[(i + 1) % outline.size()]);
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (a.y > b.y) std::swap(a, b);
        if (side(a, b, point) > 0) inside = !inside;
    }
    return inside;
}

// No edge of the outline crosses the interior of a part: the whole part is on one side of it, or the edge ends before.
bool crosses_interior(const Outline& part, Vec2 a, Vec2 b) {
    const auto on_one_side = [&](int sign) {
        return std::ranges::all_of(part, [&](Vec2 p) { return side(a, b, p) * sign <= 0; });
    };
    return !on_one_side(1) && !on_one_side(-1) && !is_separated_by_edge_of(part, {a, b});
}

// Checks in integers that the parts are a partition of the outline.
void check_partition(const Outline& outline) {
    const std::vector<Shape> shapes = decompose_outline(outline);
    std::vector<Outline> parts;
    std::int64_t area = 0;
    for (const Shape& shape : shapes) {
        parts.push_back(vertices(shape));
        REQUIRE(is_strictly_convex(parts.back()));
        area += twice_area(parts.back());
        for (const Vec2 vertex : parts.back()) REQUIRE(std::ranges::find(outline, vertex) != outline.end());
    }
    REQUIRE(area == std::abs(twice_area(outline)));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            REQUIRE((is_separated_by_edge_of(parts[i], parts[j]) || is_separated_by_edge_of(parts[j], parts[i])));
        REQUIRE(has_interior_point_inside(parts[i], outline));
        for (std::size_t k = 0; k < outline.size(); ++k)
            REQUIRE(!crosses_interior(parts[i], outline[k], outline[(k + 1) % outline.size()]));
    }
    // Hertel and Mehlhorn: at most 2 r + 1 parts for r reflex corners, four times the least number r / 2 + 1.
    std::size_t reflex = 0;
    const std::int64_t winding = twice_area(outline) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (winding * twice_area(outline[i], outline[(i + 1) % outline.size()], outline[(i + 2) % outline.size()]) < 0)
            ++reflex;
    CHECK(parts.size() <= 2 * reflex + 1);
}

mpq_class exact_twice_area(const Outline& ring) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        sum += mpq_class(a.x) * mpq_class(b.y) - mpq_class(b.x) * mpq_class(a.y);
    }
    return sum;
}

}  // namespace

TEST_CASE("a convex outline is one part, from its lowest leftmost point") {
    const std::vector<Shape> parts = decompose_outline(Outline{{2, 0}, {2, 2}, {0, 2}, {0, 0}});
    REQUIRE(parts.size() == 1);
    CHECK(vertices(parts[0]) == Outline{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST_CASE("an L is two parts with the sum of its area, in either winding") {
    Outline outline = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const std::vector<Shape> parts = decompose_outline(outline);
    REQUIRE(parts.size() == 2);
    CHECK(mass_properties(parts[0]).area + mass_properties(parts[1]).area == 5.0);  // 3 x 1 and 1 x 2
    std::reverse(outline.begin(), outline.end());
    const std::vector<Shape> reversed = decompose_outline(outline);
    REQUIRE(reversed.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) CHECK(parts[i] == reversed[i]);
}

TEST_CASE("a plus, whose four reflex corners need three parts at least, is cut into at most five") {
    const Outline plus = {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                          {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    check_partition(plus);
    const std::size_t parts = decompose_outline(plus).size();
    CHECK(parts >= 3);
    CHECK(parts <= 5);
}

TEST_CASE("equal consecutive points, a repeated first point and straight corners change nothing") {
    const Outline plain = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
    const Outline padded = {{0, 0}, {1, 0}, {1, 0}, {4, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {0, 2}, {0, 1}, {0, 0}};
    const std::vector<Shape> expected = decompose_outline(plain), parts = decompose_outline(padded);
    REQUIRE(parts.size() == expected.size());
    for (std::size_t i = 0; i < parts.size(); ++i) CHECK(parts[i] == expected[i]);
}

TEST_CASE("an outline that crosses or touches itself is refused, and the message names two edges") {
    CHECK(error_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) ==
          edge_error("0 from (0, 0) to (2, 2)", "2 from (2, 0) to (0, 2)"));
    // The corner (2, 0) lies on the edge from (0, 0) to (4, 0).
    CHECK(error_of({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}})
              .starts_with("an outline must not cross or touch itself: edge 0"));
    // Two triangles that share a corner.
    CHECK(error_of({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}).find("meets edge") != std::string::npos);
    // A spike out and back; the padding shows that edges keep the numbers of the points given.
    CHECK(error_of({{0, 0}, {2, 0}, {2, 0}, {5, 0}, {3, 0}, {2, 2}}) ==
          edge_error("2 from (2, 0) to (5, 0)", "3 from (5, 0) to (3, 0)"));
    // A hole joined by a bridge.
    CHECK(
        error_of({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}).find("meets edge") !=
        std::string::npos);
}

TEST_CASE("outlines without area, too short or not finite are refused") {
    CHECK(error_of({{0, 0}, {1, 1}, {2, 2}, {1, 1}}) == "an outline must have an area: all its points lie on one line");
    CHECK(error_of({{1, 1}, {1, 1}, {1, 1}}) == "an outline must have an area: all its points lie on one line");
    CHECK(error_of({{0, 0}, {1, 1}}) == "at least 3 points are needed, got 2");
    CHECK(
        error_of({{0, 0}, {1, 1}, {std::numeric_limits<float>::infinity(), 0}}).starts_with("point 2 must be finite"));
}

TEST_CASE("stars, combs and spirals are partitioned exactly") {
    std::mt19937_64 random(3);
    for (int count = 3; count < 60; ++count) check_partition(star(count, 1000.0f, random));
    for (int teeth = 1; teeth < 20; ++teeth) check_partition(comb(teeth, random));
    for (int turns = 1; turns < 4; ++turns) check_partition(spiral(turns, 7 + turns));
}

TEST_CASE("random simple polygons are partitioned exactly") {
    std::mt19937_64 random(4);
    int checked = 0;
    for (int sample = 0; sample < 2000; ++sample) {
        const std::array<int, 3> sizes = {4, 12, 1000};  // on small grids straight corners are common
        const Outline outline = untangled(3 + sample % 30, sizes[static_cast<std::size_t>(sample % 3)], random);
        const bool has_equal_points =
            std::ranges::adjacent_find(outline) != outline.end() || outline.front() == outline.back();
        if (has_equal_points || !is_simple(outline) || twice_area(outline) == 0) continue;
        ++checked;
        check_partition(outline);
    }
    CHECK(checked > 1000);
}

TEST_CASE("a random closed line is refused if and only if two of its edges share a point") {
    std::mt19937_64 random(5);
    std::map<bool, int> simple;
    for (int sample = 0; sample < 20000; ++sample) {
        std::uniform_int_distribution<int> coordinate(0, 3 + sample % 6);
        Outline outline;
        for (int i = 0; i < 4 + sample % 3; ++i)
            outline.push_back({static_cast<float>(coordinate(random)), static_cast<float>(coordinate(random))});
        if (std::ranges::adjacent_find(outline) != outline.end() || outline.front() == outline.back()) continue;
        const bool is_valid = is_simple(outline) && twice_area(outline) != 0;
        ++simple[is_valid];
        REQUIRE((error_of(outline) == "no error") == is_valid);
    }
    CHECK(simple[true] > 3000);
    CHECK(simple[false] > 3000);
}

TEST_CASE("areas agree exactly where floats do not lie on a grid") {
    // Coordinates of every size from 1e-12 to 1e6 around thin stars: rounding would show in any inexact step.
    std::mt19937_64 random(6);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int sample = 0; sample < 200; ++sample) {
        Outline outline;
        for (int i = 0; i < 40; ++i) {
            const float radius = std::pow(10.0f, -12.0f + 18.0f * unit(random)),
                        turn = 2.0f * static_cast<float>(kPi) * static_cast<float>(i) / 40.0f;
            outline.push_back({radius * std::cos(turn), radius * std::sin(turn)});
        }
        mpq_class area = 0;
        for (const Shape& part : decompose_outline(outline)) area += exact_twice_area(vertices(part));
        REQUIRE(area == exact_twice_area(outline));
    }
}

TEST_CASE("no two parts beside an edge could be one: without it one of its ends is reflex") {
    std::mt19937_64 random(7);
    int shared = 0;
    for (int sample = 0; sample < 30; ++sample) {
        std::map<std::array<float, 4>, std::array<Vec2, 2>> edges;  // from x, y, to x, y: the corners before and after
        for (const Shape& part : decompose_outline(star(40, 1000.0f, random))) {
            const Outline ring = vertices(part);
            const std::size_t n = ring.size();
            for (std::size_t i = 0; i < n; ++i) {
                const Vec2 from = ring[i], to = ring[(i + 1) % n];
                edges[{from.x, from.y, to.x, to.y}] = {ring[(i + n - 1) % n], ring[(i + 2) % n]};
            }
        }
        for (const auto& [edge, around] : edges) {
            const Vec2 from{edge[0], edge[1]}, to{edge[2], edge[3]};
            const auto twin = edges.find({to.x, to.y, from.x, from.y});
            if (twin == edges.end()) continue;
            ++shared;
            const int turn_at_from = side(around[0], from, twin->second[1]),
                      turn_at_to = side(twin->second[0], to, around[1]);
            CHECK(std::min(turn_at_from, turn_at_to) < 0);
        }
    }
    CHECK(shared > 500);
}

TEST_CASE("ten thousand points take less than a second; a large convex outline is cut at the largest shape") {
    std::mt19937_64 random(8);
    const Outline large = star(10000, 1000000.0f, random);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Shape> parts = decompose_outline(large);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
    std::int64_t area = 0;
    for (const Shape& part : parts) area += twice_area(vertices(part));
    CHECK(area == twice_area(large));

    // All steps of coprime integers up to 170, by slope, in four quarter turns: a convex outline of over 70 000
    // corners.
    std::vector<Vec2> steps;
    for (int x = 1; x <= 170; ++x)
        for (int y = 1; y <= 170; ++y)
            if (std::gcd(x, y) == 1) steps.push_back({static_cast<float>(x), static_cast<float>(y)});
    std::sort(steps.begin(), steps.end(), [](Vec2 a, Vec2 b) { return cross(a, b) > 0.0f; });
    Outline convex = {{0, 0}};
    for (int quarter = 0; quarter < 4; ++quarter)
        for (Vec2& step : steps) {
            convex.push_back(convex.back() + step);
            step = perp(step);
        }
    REQUIRE(convex.back() == convex.front());
    REQUIRE(convex.size() > 70000);
    const std::vector<Shape> pieces = decompose_outline(convex);
    REQUIRE(pieces.size() == 2);
    CHECK(std::max(pieces[0].vertex_count(), pieces[1].vertex_count()) <= Shape::kMaxVertices);
    CHECK(pieces[0].vertex_count() + pieces[1].vertex_count() == static_cast<int>(convex.size()) - 1 + 2);
}
