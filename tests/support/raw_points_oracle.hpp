// The exact signed distance of the convex hulls of two sets of points, from the points as given: by rationals and brute
// force, without Shape and without the library's hull.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <span>
#include <vector>

#include "tumble/math.hpp"

namespace tumble::test {

struct RationalPoint {
    mpq_class x, y;

    friend bool operator<(const RationalPoint& p, const RationalPoint& q) {
        const int by_x = cmp(p.x, q.x);
        return by_x != 0 ? by_x < 0 : cmp(p.y, q.y) < 0;
    }
    friend bool operator==(const RationalPoint& p, const RationalPoint& q) { return p.x == q.x && p.y == q.y; }
};

struct IntegerPoint {
    mpz_class x, y;
};

inline mpz_class cross(const IntegerPoint& o, const IntegerPoint& p, const IntegerPoint& q) {
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

// In world coordinates, with the rotation taken literally.
inline std::vector<RationalPoint> world_points(std::span<const Vec2> points, const Pose& pose) {
    const mpq_class c(pose.rotation.c), s(pose.rotation.s), px(pose.position.x), py(pose.position.y);
    std::vector<RationalPoint> result;
    for (const Vec2 point : points) {
        const mpq_class x(point.x), y(point.y);
        result.push_back({c * x - s * y + px, s * x + c * y + py});
    }
    return result;
}

// All denominators are powers of two: the largest is the common unit.
inline std::vector<IntegerPoint> in_units(const std::vector<RationalPoint>& points, const mpz_class& unit) {
    std::vector<IntegerPoint> result;
    for (const RationalPoint& point : points) result.push_back({mpz_class(point.x * unit), mpz_class(point.y * unit)});
    return result;
}

// Gift wrapping: from the least point, the next vertex has no point on the right of the edge to it; of collinear ones
// the farthest.
inline std::vector<IntegerPoint> wrapped_hull(const std::vector<IntegerPoint>& points) {
    const auto is_less = [](const IntegerPoint& p, const IntegerPoint& q) {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    };
    const auto is_same = [](const IntegerPoint& p, const IntegerPoint& q) { return p.x == q.x && p.y == q.y; };
    const auto distance_sq = [](const IntegerPoint& p, const IntegerPoint& q) {
        return mpz_class((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
    };
    std::vector<IntegerPoint> hull = {*std::min_element(points.begin(), points.end(), is_less)};
    for (;;) {
        const IntegerPoint from = hull.back();
        const IntegerPoint* next = nullptr;
        for (const IntegerPoint& point : points) {
            if (is_same(point, from)) continue;
            const int side = next ? sgn(cross(from, *next, point)) : -1;
            if (side < 0 || (side == 0 && distance_sq(from, point) > distance_sq(from, *next))) next = &point;
        }
        if (!next || is_same(*next, hull.front())) return hull;
        hull.push_back(*next);
    }
}

class RawPointsDistance {
public:
    RawPointsDistance(std::span<const Vec2> a, const Pose& pose_a, std::span<const Vec2> b, const Pose& pose_b) {
        const std::vector<RationalPoint> world_a = world_points(a, pose_a), world_b = world_points(b, pose_b);
        unit_ = 1;
        for (const std::vector<RationalPoint>* points : {&world_a, &world_b})
            for (const RationalPoint& point : *points)
                unit_ = std::max(unit_, std::max(mpz_class(point.x.get_den()), mpz_class(point.y.get_den())));
        const std::vector<IntegerPoint> hull_a = wrapped_hull(in_units(world_a, unit_)),
                                        hull_b = wrapped_hull(in_units(world_b, unit_));
        vertices_ = hull_a.size() + hull_b.size();
        const bool has_depth = overlap(hull_a, hull_b) && overlap(hull_b, hull_a) && sign_ < 0;
        if (has_depth) return;
        keep_nearest(hull_a, hull_b);
        keep_nearest(hull_b, hull_a);
        sign_ = sgn(square_);
    }

    // The sign of the signed distance of the hulls, each grown by its radius, minus `value`.
    int compare(double value, double radii = 0.0) const {
        const mpq_class bound = (mpq_class(value) + mpq_class(radii)) * unit_;
        if (sign_ != sgn(bound)) return sign_ < sgn(bound) ? -1 : 1;
        const int by_square = cmp(square_, mpq_class(bound * bound));
        return sign_ * (by_square > 0 ? 1 : by_square < 0 ? -1 : 0);
    }

    std::size_t hull_vertices() const { return vertices_; }  // of both hulls

private:
    // Whether the hulls overlap along all edge normals of `own`; the least penetration is kept.
    bool overlap(const std::vector<IntegerPoint>& own, const std::vector<IntegerPoint>& other) {
        for (std::size_t i = 0; i < own.size() && own.size() > 1; ++i) {
            const IntegerPoint &from = own[i], &to = own[(i + 1) % own.size()];
            mpz_class least = 0;  // cross product: positive on the inner side
            for (std::size_t j = 0; j < other.size(); ++j) {
                const mpz_class out = -cross(from, to, other[j]);
                if (j == 0 || out < least) least = out;
            }
            if (least >= 0) return false;
            const mpz_class length_sq = (to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y);
            mpq_class square(mpz_class(least * least), length_sq);
            square.canonicalize();
            if (sign_ != 0 && square >= square_) continue;
            square_ = square;
            sign_ = -1;
        }
        return true;
    }

    // Between all vertices of one hull and all edges of the other.
    void keep_nearest(const std::vector<IntegerPoint>& points, const std::vector<IntegerPoint>& edges) {
        for (const IntegerPoint& point : points) {
            for (std::size_t i = 0; i < edges.size(); ++i) {
                const IntegerPoint &from = edges[i], &to = edges[(i + 1) % edges.size()];
                const mpz_class edge_x = to.x - from.x, edge_y = to.y - from.y, x = point.x - from.x,
                                y = point.y - from.y;
                const mpz_class along = edge_x * x + edge_y * y, length_sq = edge_x * edge_x + edge_y * edge_y;
                if (along >= length_sq && length_sq > 0) continue;  // nearest to `to`, the start of the next edge
                mpz_class numerator = x * x + y * y, denominator = 1;
                if (along > 0) {
                    numerator = edge_x * y - edge_y * x;
                    numerator *= numerator;
                    denominator = length_sq;
                }
                if (is_found_ && numerator * square_.get_den() >= square_.get_num() * denominator) continue;
                is_found_ = true;
                square_ = mpq_class(numerator, denominator);
                square_.canonicalize();
            }
        }
    }

    mpz_class unit_;
    mpq_class square_ = 0;  // of the distance, in units
    int sign_ = 0;
    bool is_found_ = false;
    std::size_t vertices_ = 0;
};

}  // namespace tumble::test
