// Seeded random shapes, poses and pairs for property tests.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "tumble/distance.hpp"
#include "tumble/shape.hpp"

namespace tumble_test {

struct Pair {
    tumble::Shape a;
    tumble::Pose pose_a;
    tumble::Shape b;
    tumble::Pose pose_b;
};

class PairSource {
public:
    explicit PairSource(unsigned seed) : random_(seed) {}

    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
    bool coin() { return below(2) == 1; }

    // Points, segments, polygons of up to eight vertices, and ellipses of up to sixty, of size about `size`.
    tumble::Shape shape(double size, float radius = 0.0f) {
        const int kind = below(8);
        if (kind == 7) return ellipse(9 + below(52), size, size * uniform(0.01, 1.0), radius);
        const int count = kind < 2 ? kind + 1 : 3 + below(6);
        const double x = uniform(-size, size), y = uniform(-size, size);
        std::vector<tumble::Vec2> points;
        for (int i = 0; i < count; ++i) points.push_back(point(x + uniform(-size, size), y + uniform(-size, size)));
        return tumble::make_polygon(points, radius);
    }

    tumble::Shape ellipse(int count, double half_width, double half_height, float radius = 0.0f) {
        std::vector<tumble::Vec2> points;
        for (int i = 0; i < count; ++i) {
            const tumble::SinCos at = tumble::sin_cos(2.0 * tumble::kPi * i / count);
            points.push_back(point(half_width * at.cos, half_height * at.sin));
        }
        return tumble::make_polygon(points, radius);
    }

    tumble::Pose pose(double range) {
        return {{uniform(-range, range), uniform(-range, range)}, tumble::make_rotation(uniform(-3.2, 3.2))};
    }

    Pair pair() { return {shape(1.0), pose(2.0), shape(1.0), pose(2.0)}; }

    // A pair whose signed distance is about +-10^[-12, -1].
    Pair near_pair() {
        Pair near = pair();
        const double gap = (coin() ? 1.0 : -1.0) * std::pow(10.0, uniform(-12.0, -1.0));
        move_to_gap(near, gap);
        return near;
    }

    static void move_to_gap(Pair& pair, double gap) {
        for (int round = 0; round < 2; ++round) {
            const tumble::DistanceResult now = tumble::distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
            pair.pose_b.position += (gap - now.distance) * now.normal;
        }
    }

private:
    static tumble::Vec2 point(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

    std::mt19937_64 random_;
};

inline tumble::DistanceResult measure(const Pair& pair, tumble::SimplexCache* cache = nullptr) {
    return tumble::distance(pair.a, pair.pose_a, pair.b, pair.pose_b, cache);
}

// The scale that error bounds are relative to, for unit rotations: u (RA + RB + |p|).
inline double rounding_of(const Pair& pair) {
    return 0x1p-53 *
           (pair.a.core_radius() + pair.b.core_radius() + tumble::length(pair.pose_b.position - pair.pose_a.position));
}

}  // namespace tumble_test
