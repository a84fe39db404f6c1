// GJK as its authors wrote it, in any dimension: the textbook form of the engine's two-dimensional loop.
//
// Support mappings describe the sets [GJK88, GF90]; Johnson's distance subalgorithm finds the nearest point of the
// simplex by recursive cofactors over all of its subsets, with the backup procedure for when rounding leaves no subset
// that satisfies every sign condition [GJK88, section 5; vdB04, 4.3]. Written for clarity, not for speed: distance() is
// the fast implementation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace tumble::reference {

template <int Dim>
using Point = Eigen::Matrix<double, Dim, 1>;

// At most Dim + 1 affinely independent points.
template <int Dim>
struct GjkSimplex {
    std::array<Point<Dim>, Dim + 1> points{};
    int count = 0;
};

// The point of a simplex nearest to the origin, and the smallest sub-simplex that contains it.
template <int Dim>
struct NearestPoint {
    Point<Dim> point = Point<Dim>::Zero();
    GjkSimplex<Dim> simplex;
    bool used_backup = false;
};

// Johnson's subalgorithm. For a subset X of the points and i in X, delta_i(X) is the cofactor that makes
// sum_i delta_i y_i / sum_i delta_i the point of the affine hull of X nearest to the origin:
//   delta_i({i}) = 1,  delta_j(X + j) = sum over i in X of delta_i(X) (y_i . y_k - y_i . y_j),  k any one of X.
// X contains the answer if all delta_i(X) > 0 and no j outside X has delta_j(X + j) > 0.
template <int Dim>
NearestPoint<Dim> johnson_nearest_point(const GjkSimplex<Dim>& simplex) {
    constexpr unsigned kSubsets = 1u << (Dim + 1);
    const unsigned subsets = 1u << simplex.count;
    std::array<std::array<double, Dim + 1>, kSubsets> delta{};
    const auto member = [](unsigned subset, int i) { return (subset >> i & 1u) != 0; };

    for (unsigned subset = 1; subset < subsets; ++subset) {
        for (int j = 0; j < simplex.count; ++j) {
            if (!member(subset, j)) continue;
            const unsigned rest = subset & ~(1u << j);
            if (rest == 0) {
                delta[subset][static_cast<std::size_t>(j)] = 1.0;
                continue;
            }
            int k = 0;
            while (!member(rest, k)) ++k;
            const Point<Dim> edge =
                simplex.points[static_cast<std::size_t>(k)] - simplex.points[static_cast<std::size_t>(j)];
            double sum = 0.0;
            for (int i = 0; i < simplex.count; ++i)
                if (member(rest, i))
                    sum += delta[rest][static_cast<std::size_t>(i)] *
                           simplex.points[static_cast<std::size_t>(i)].dot(edge);
            delta[subset][static_cast<std::size_t>(j)] = sum;
        }
    }

    const auto all_positive = [&](unsigned subset) {
        for (int i = 0; i < simplex.count; ++i)
            if (member(subset, i) && !(delta[subset][static_cast<std::size_t>(i)] > 0.0)) return false;
        return true;
    };
    const auto none_outside = [&](unsigned subset) {
        for (int j = 0; j < simplex.count; ++j)
            if (!member(subset, j) && delta[subset | 1u << j][static_cast<std::size_t>(j)] > 0.0) return false;
        return true;
    };
    const auto take = [&](unsigned subset) {
        NearestPoint<Dim> nearest;
        double total = 0.0;
        for (int i = 0; i < simplex.count; ++i) {
            if (!member(subset, i)) continue;
            const double weight = delta[subset][static_cast<std::size_t>(i)];
            nearest.point += weight * simplex.points[static_cast<std::size_t>(i)];
            total += weight;
            nearest.simplex.points[static_cast<std::size_t>(nearest.simplex.count++)] =
                simplex.points[static_cast<std::size_t>(i)];
        }
        nearest.point /= total;
        return nearest;
    };

    for (unsigned subset = 1; subset < subsets; ++subset)
        if (all_positive(subset) && none_outside(subset)) return take(subset);

    // Backup: of all subsets whose own cofactors are positive (single points always are), the nearest.
    NearestPoint<Dim> best = take(1);
    for (unsigned subset = 2; subset < subsets; ++subset) {
        if (!all_positive(subset)) continue;
        const NearestPoint<Dim> candidate = take(subset);
        if (candidate.point.squaredNorm() < best.point.squaredNorm()) best = candidate;
    }
    best.used_backup = true;
    return best;
}

template <int Dim>
struct GjkResult {
    double distance = 0.0;                    // 0 if the sets overlap
    Point<Dim> nearest = Point<Dim>::Zero();  // the point of A - B nearest to the origin
    int iterations = 0;
};

// The distance of A - B from the origin. `support(d)` returns a point of A - B farthest in direction d: s_A(d) -
// s_B(-d). Stops when the bounds on the distance agree to the relative `tolerance` (for smooth sets the convergence is
// gradual), when the simplex contains the origin in its interior, or after `max_iterations`.
template <int Dim, class Support>
GjkResult<Dim> reference_gjk(const Support& support, double tolerance = 1e-12, int max_iterations = 1000) {
    GjkResult<Dim> result;
    GjkSimplex<Dim> simplex;
    Point<Dim> v = support(Point<Dim>::Unit(0));
    double largest_sq = v.squaredNorm();
    for (; result.iterations < max_iterations; ++result.iterations) {
        const Point<Dim> w = support(Point<Dim>(-v));
        largest_sq = std::max(largest_sq, w.squaredNorm());
        if (v.squaredNorm() - v.dot(w) <= tolerance * v.squaredNorm()) break;
        simplex.points[static_cast<std::size_t>(simplex.count++)] = w;
        const NearestPoint<Dim> reduced = johnson_nearest_point(simplex);
        const bool nearer = reduced.point.squaredNorm() < v.squaredNorm();
        if (!nearer && result.iterations > 0) break;
        v = reduced.point;
        simplex = reduced.simplex;
        const double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        if (simplex.count == Dim + 1 || v.squaredNorm() <= rounding * rounding * largest_sq) return result;
    }
    result.nearest = v;
    result.distance = v.norm();
    return result;
}

}  // namespace tumble::reference
