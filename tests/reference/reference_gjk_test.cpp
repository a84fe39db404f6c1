// The dimension-generic GJK against closed forms and brute force, in 2D and 3D.
#include "reference/exact/reference_gjk.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace tumble::reference;

namespace {

template <int Dim>
using Cloud = std::vector<Point<Dim>>;

template <int Dim>
Point<Dim> farthest(const Cloud<Dim>& points, const Point<Dim>& direction) {
    return *std::max_element(points.begin(), points.end(), [&](const Point<Dim>& p, const Point<Dim>& q) {
        return p.dot(direction) < q.dot(direction);
    });
}

template <int Dim>
double cloud_distance(const Cloud<Dim>& a, const Cloud<Dim>& b) {
    const auto support = [&](const Point<Dim>& d) -> Point<Dim> {
        return farthest<Dim>(a, d) - farthest<Dim>(b, Point<Dim>(-d));
    };
    return reference_gjk<Dim>(support).distance;
}

template <int Dim>
Cloud<Dim> random_cloud(std::mt19937_64& random, int count, const Point<Dim>& center) {
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    Cloud<Dim> cloud;
    for (int i = 0; i < count; ++i) {
        Point<Dim> p;
        for (int axis = 0; axis < Dim; ++axis) p[axis] = coordinate(random);
        cloud.push_back(center + p);
    }
    return cloud;
}

// The eight corners (four in 2D) of an axis-aligned box.
template <int Dim>
Cloud<Dim> box(const Point<Dim>& lower, const Point<Dim>& upper) {
    Cloud<Dim> corners;
    for (unsigned bits = 0; bits < 1u << Dim; ++bits) {
        Point<Dim> p;
        for (int axis = 0; axis < Dim; ++axis) p[axis] = (bits >> axis & 1u) != 0 ? upper[axis] : lower[axis];
        corners.push_back(p);
    }
    return corners;
}

// Frank and Wolfe's iteration with away steps on the same difference: slow, and shares no code with GJK. Its duality
// gap, the maximum over w of v . (v - w), bounds the error: distance >= |v| - gap / |v|.
template <int Dim>
double brute_force_distance(const Cloud<Dim>& a, const Cloud<Dim>& b) {
    Cloud<Dim> w;
    for (const Point<Dim>& p : a)
        for (const Point<Dim>& q : b) w.push_back(p - q);
    std::vector<double> weight(w.size(), 0.0);
    weight[0] = 1.0;
    Point<Dim> v = w[0];
    for (int iteration = 0; iteration < 200000; ++iteration) {
        std::size_t toward = 0, away = 0;
        double least = INFINITY, most = -INFINITY;
        for (std::size_t i = 0; i < w.size(); ++i) {
            const double along = v.dot(w[i]);
            if (along < least) {
                least = along;
                toward = i;
            }
            if (weight[i] > 0.0 && along > most) {
                most = along;
                away = i;
            }
        }
        if (v.squaredNorm() - least <= 1e-13 * v.squaredNorm()) break;
        const Point<Dim> step = w[toward] - w[away];  // moves weight from the worst active point to the best
        const double t = std::min(weight[away], -v.dot(step) / step.squaredNorm());
        weight[away] -= t;
        weight[toward] += t;
        v += t * step;
    }
    return v.norm();
}

template <int Dim>
void compare_with_brute_force(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> offset(-1.6, 1.6);
    int separated = 0;
    const int samples = 300;
    for (int sample = 0; sample < samples; ++sample) {
        Point<Dim> center = Point<Dim>::Zero();
        center[0] = offset(random);
        center[1] = offset(random) * 0.5;
        const Cloud<Dim> a = random_cloud<Dim>(random, Dim + 1, Point<Dim>::Zero());
        const Cloud<Dim> b = random_cloud<Dim>(random, Dim + 1, center);
        const double expected = brute_force_distance<Dim>(a, b);
        const double found = cloud_distance<Dim>(a, b);
        if (expected > 1e-4) {
            ++separated;
            CHECK(found == doctest::Approx(expected).epsilon(1e-9));
        } else {
            CHECK(found < 1e-4);
        }
    }
    CHECK(separated > samples * 3 / 10);
    CHECK(separated < samples * 8 / 10);
}

}  // namespace

TEST_CASE("simplices in the plane agree with brute force") { compare_with_brute_force<2>(11); }
TEST_CASE("tetrahedra in space agree with brute force") { compare_with_brute_force<3>(12); }

TEST_CASE("axis-aligned boxes have the distance of their gaps") {
    using P2 = Point<2>;
    using P3 = Point<3>;
    CHECK(cloud_distance<2>(box<2>(P2(0, 0), P2(1, 1)), box<2>(P2(4, 5), P2(6, 6))) ==
          doctest::Approx(5.0).epsilon(1e-14));
    // Gaps of 2, 3 and 6 along the axes: sqrt(4 + 9 + 36) = 7.
    CHECK(cloud_distance<3>(box<3>(P3(0, 0, 0), P3(1, 1, 1)), box<3>(P3(3, 4, 7), P3(5, 5, 8))) ==
          doctest::Approx(7.0).epsilon(1e-14));
    CHECK(cloud_distance<3>(box<3>(P3(0, 0, 0), P3(2, 2, 2)), box<3>(P3(1, 1, 1), P3(3, 3, 3))) == 0.0);
    CHECK(cloud_distance<3>(box<3>(P3(0, 0, 0), P3(4, 4, 4)), box<3>(P3(1, 1, 1), P3(2, 2, 2))) == 0.0);
}

TEST_CASE("spheres, given by their support mapping alone, have the distance of their centres less the radii") {
    const Point<3> center_a(0, 0, 0), center_b(2, 3, 6);  // 7 apart
    const double radius_a = 1.0, radius_b = 2.5;
    const auto support = [&](const Point<3>& d) -> Point<3> {
        return center_a + radius_a * d.normalized() - (center_b - radius_b * d.normalized());
    };
    const GjkResult<3> result = reference_gjk<3>(support, 1e-12);
    CHECK(result.distance == doctest::Approx(3.5).epsilon(1e-9));
    CHECK(result.nearest.normalized().dot((center_a - center_b).normalized()) == doctest::Approx(1.0).epsilon(1e-9));
}

TEST_CASE("Johnson's cofactors find the vertex, the edge and the face regions of a triangle") {
    // The triangle (1, -1), (1, 1), (3, 0): its edge x = 1 is nearest, at (1, 0).
    GjkSimplex<2> triangle{{Point<2>(1, -1), Point<2>(1, 1), Point<2>(3, 0)}, 3};
    NearestPoint<2> nearest = johnson_nearest_point(triangle);
    CHECK(nearest.simplex.count == 2);
    CHECK(nearest.point == Point<2>(1, 0));

    // Shifted up by 3, its vertex (1, 2) is nearest.
    for (Point<2>& p : triangle.points) p += Point<2>(0, 3);
    nearest = johnson_nearest_point(triangle);
    CHECK(nearest.simplex.count == 1);
    CHECK(nearest.point == Point<2>(1, 2));

    // Shifted to the left by 2 from the first position, it contains the origin.
    triangle = {{Point<2>(-1, -1), Point<2>(-1, 1), Point<2>(1, 0)}, 3};
    nearest = johnson_nearest_point(triangle);
    CHECK(nearest.simplex.count == 3);
    CHECK(nearest.point.norm() < 1e-15);
    CHECK_FALSE(nearest.used_backup);
}

TEST_CASE("a point repeated in the simplex does not mislead the subalgorithm") {
    const GjkSimplex<2> flat{{Point<2>(2, 1), Point<2>(2, 1), Point<2>(2, -1)}, 3};
    CHECK((johnson_nearest_point(flat).point - Point<2>(2, 0)).norm() < 1e-15);
}
