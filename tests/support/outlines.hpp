// Families of simple polygons for tests, on integer coordinates so that areas and sides are exact in 64 bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "tumble/math.hpp"

namespace tumble::test {

using Outline = std::vector<Vec2>;

// Points in the order of their angles, at random radii.
inline Outline star(int count, float size, std::mt19937_64& random) {
    std::uniform_real_distribution<double> radius(0.1 * size, size);
    Outline points;
    for (int i = 0; i < count; ++i) {
        const double r = radius(random), turn = 2.0 * kPi * i / count;
        points.push_back(
            {static_cast<float>(std::round(r * std::cos(turn))), static_cast<float>(std::round(r * std::sin(turn)))});
    }
    return points;
}

// Teeth of random length on a bar.
inline Outline comb(int teeth, std::mt19937_64& random) {
    std::uniform_int_distribution<int> length(1, 50);
    Outline points = {{0, -5}};
    for (int tooth = 0; tooth < teeth; ++tooth) {
        const auto x = static_cast<float>(4 * tooth), tip = static_cast<float>(length(random));
        for (const Vec2 point : {Vec2{x, 0}, Vec2{x, tip}, Vec2{x + 2, tip}, Vec2{x + 2, 0}}) points.push_back(point);
    }
    points.push_back({static_cast<float>(4 * teeth - 2), -5});
    std::reverse(points.begin(), points.end());
    return points;
}

// A corridor 150 wide, wound up with a pitch of 400.
inline Outline spiral(int turns, int points_a_turn) {
    Outline points, back;
    for (int i = 0; i <= turns * points_a_turn; ++i) {
        const double turn = 2.0 * kPi * i / points_a_turn, radius = 400.0 + 400.0 * i / points_a_turn;
        const auto at = [&](double r) {
            return Vec2{static_cast<float>(std::round(r * std::cos(turn))),
                        static_cast<float>(std::round(r * std::sin(turn)))};
        };
        points.push_back(at(radius + 150.0));
        back.push_back(at(radius));
    }
    points.insert(points.end(), back.rbegin(), back.rend());
    return points;
}

inline std::int64_t twice_area(Vec2 a, Vec2 b, Vec2 c) {
    const auto i = [](float value) { return static_cast<std::int64_t>(value); };
    return (i(b.x) - i(a.x)) * (i(c.y) - i(a.y)) - (i(b.y) - i(a.y)) * (i(c.x) - i(a.x));
}

inline std::int64_t twice_area(const Outline& ring) {
    std::int64_t sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += twice_area(ring[0], ring[i], ring[i + 1]);
    return sum;
}

inline int side(Vec2 a, Vec2 b, Vec2 c) {
    const std::int64_t area = twice_area(a, b, c);
    return (area > 0) - (area < 0);
}

// True if the closed segments share a point.
inline bool segments_share_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto boxes_meet = [](float a0, float a1, float b0, float b1) {
        return std::max(std::min(a0, a1), std::min(b0, b1)) <= std::min(std::max(a0, a1), std::max(b0, b1));
    };
    return boxes_meet(a.x, b.x, c.x, d.x) && boxes_meet(a.y, b.y, c.y, d.y) && side(a, b, c) * side(a, b, d) <= 0 &&
           side(c, d, a) * side(c, d, b) <= 0;
}

// All pairs: the definition of a simple polygon, for points that differ from their successors.
inline bool is_simple(const Outline& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
        const bool turns_back = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0.0f;
        if (side(a, b, c) == 0 && turns_back) return false;
        for (std::size_t j = i + 2; j < n; ++j) {
            const bool adjacent = i == 0 && j + 1 == n;
            if (!adjacent && segments_share_point(a, b, ring[j], ring[(j + 1) % n])) return false;
        }
    }
    return true;
}

// Random points joined at random, then untangled: two edges that cross are exchanged for two shorter ones. May end not
// simple where points lie on lines; the caller checks is_simple().
inline Outline untangled(int count, int size, std::mt19937_64& random) {
    std::uniform_int_distribution<int> coordinate(-size, size);
    Outline ring;
    for (int i = 0; i < count; ++i)
        ring.push_back({static_cast<float>(coordinate(random)), static_cast<float>(coordinate(random))});
    const std::size_t n = ring.size();
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i + 2 < n; ++i)
            for (std::size_t j = i + 2; j < n; ++j) {
                const Vec2 a = ring[i], b = ring[i + 1], c = ring[j], d = ring[(j + 1) % n];
                if (!segments_share_point(a, b, c, d)) continue;
                // Shorter by more than rounding, so that the loop ends.
                if (length(DVec2(c - a)) + length(DVec2(d - b)) >= length(DVec2(b - a)) + length(DVec2(d - c)) - 1e-9)
                    continue;
                std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                changed = true;
            }
    }
    return ring;
}

}  // namespace tumble::test
