// The dimension-generic GJK against closed forms in one to six dimensions, and against brute force in two and three.
#include "reference/exact/reference_gjk.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include "support/near.hpp"

using namespace tumble::reference;
using namespace tumble::test;

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

// The 2^Dim corners of an axis-aligned box.
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
            CHECK(near(found, expected, relative(1e-12)));
        } else {
            CHECK(found < 1e-4);
        }
    }
    CHECK(separated > samples * 3 / 10);
    CHECK(separated < samples * 8 / 10);
}

// Two random reflections (a rotation) and a translation: they leave all distances as they are.
template <int Dim>
class RigidMotion {
public:
    explicit RigidMotion(std::mt19937_64& random)
        : first_(random_vector(random).normalized()),
          second_(random_vector(random).normalized()),
          shift_(random_vector(random)) {}

    Point<Dim> operator()(const Point<Dim>& p) const { return reflected(reflected(p, first_), second_) + shift_; }
    Cloud<Dim> operator()(Cloud<Dim> cloud) const {
        for (Point<Dim>& p : cloud) p = (*this)(p);
        return cloud;
    }

private:
    static Point<Dim> random_vector(std::mt19937_64& random) {
        std::normal_distribution<double> coordinate;
        Point<Dim> v;
        for (int axis = 0; axis < Dim; ++axis) v[axis] = coordinate(random);
        return v;
    }
    static Point<Dim> reflected(const Point<Dim>& p, const Point<Dim>& unit) { return p - 2.0 * unit.dot(p) * unit; }

    Point<Dim> first_, second_, shift_;
};

// Two boxes whose intervals along each axis are apart, overlap or touch at random: the distance is the root of the sum
// of the squared gaps.
template <int Dim>
void compare_boxes() {
    std::mt19937_64 random(20 + Dim);
    std::uniform_real_distribution<double> size(0.5, 2.0), gap(-1.0, 1.0);
    const int samples = 200;
    int separated = 0;
    for (int sample = 0; sample < samples; ++sample) {
        Point<Dim> lower_a, upper_a, lower_b, upper_b;
        double expected_sq = 0.0;
        for (int axis = 0; axis < Dim; ++axis) {
            const double between = gap(random) + (sample % 2 == 0 ? -1.0 : 0.0);
            lower_a[axis] = -size(random);
            upper_a[axis] = 0.5;
            lower_b[axis] = upper_a[axis] + between;
            upper_b[axis] = lower_b[axis] + 2.0 + size(random);
            expected_sq += between > 0.0 ? between * between : 0.0;
        }
        const RigidMotion<Dim> motion(random);
        const double found =
            cloud_distance<Dim>(motion(box<Dim>(lower_a, upper_a)), motion(box<Dim>(lower_b, upper_b)));
        separated += expected_sq > 0.0;
        if (expected_sq > 0.0)
            CHECK(near(found, std::sqrt(expected_sq), relative(1e-10)));
        else
            CHECK(found < 1e-13);
    }
    CHECK(separated > samples * 2 / 10);
    CHECK(separated < samples * 8 / 10);
}

// The simplex of s e_1 ... s e_Dim and a point beyond that face: the face is s / sqrt(Dim) from the origin. With a
// point on the other side instead, the simplex contains the origin. Its vertex alone is the nearest from behind.
template <int Dim>
void compare_simplices() {
    std::mt19937_64 random(30 + Dim);
    std::uniform_real_distribution<double> size(0.5, 2.0);
    for (int sample = 0; sample < 100; ++sample) {
        const RigidMotion<Dim> motion(random);
        const double s = size(random), beyond = s + size(random);
        Cloud<Dim> face;
        for (int axis = 0; axis < Dim; ++axis) face.push_back(s * Point<Dim>::Unit(axis));
        const auto with = [&](double tip) {
            Cloud<Dim> simplex = face;
            simplex.push_back(Point<Dim>::Constant(tip));
            return motion(simplex);
        };
        const auto from = [&](double along) { return Cloud<Dim>{motion(Point<Dim>::Constant(along))}; };
        const double root = std::sqrt(static_cast<double>(Dim));
        CHECK(near(cloud_distance<Dim>(with(beyond), from(0.0)), s / root, relative(1e-10)));
        CHECK(near(cloud_distance<Dim>(with(beyond), from(beyond + s)), s * root, relative(1e-10)));
        CHECK(cloud_distance<Dim>(with(-beyond), from(0.0)) < 1e-13);
    }
}

// Balls by their support mapping alone, and the point as the ball of radius 0.
template <int Dim>
void compare_balls() {
    std::mt19937_64 random(40 + Dim);
    std::uniform_real_distribution<double> coordinate(-3.0, 3.0), radius(0.0, 1.5);
    int separated = 0;
    const int samples = 200;
    for (int sample = 0; sample < samples; ++sample) {
        Point<Dim> offset;
        for (int axis = 0; axis < Dim; ++axis) offset[axis] = coordinate(random) / std::sqrt(static_cast<double>(Dim));
        const double radii = sample % 4 == 0 ? 0.0 : radius(random) + (sample % 4 == 1 ? 0.0 : radius(random));
        const auto support = [&](const Point<Dim>& d) -> Point<Dim> { return radii * d.normalized() - offset; };
        const double expected = offset.norm() - radii;
        const double found = reference_gjk<Dim>(support).distance;
        separated += expected > 0.0;
        if (expected > 1e-3)
            CHECK(near(found, expected, relative(1e-9)));
        else if (expected < -1e-3)
            CHECK(found < 1e-6);
    }
    CHECK(separated > samples * 3 / 10);
    CHECK(separated < samples * 9 / 10);
}

template <int Dim>
using Dimension = std::integral_constant<int, Dim>;

}  // namespace

TEST_CASE_TEMPLATE("boxes, simplices and balls have their closed-form distances in one to six dimensions", T,
                   Dimension<1>, Dimension<2>, Dimension<3>, Dimension<4>, Dimension<6>) {
    CAPTURE(T::value);
    compare_boxes<T::value>();
    compare_simplices<T::value>();
    compare_balls<T::value>();
}

TEST_CASE("simplices in the plane agree with brute force") { compare_with_brute_force<2>(11); }
TEST_CASE("tetrahedra in space agree with brute force") { compare_with_brute_force<3>(12); }

TEST_CASE("axis-aligned boxes have the distance of their gaps") {
    using P2 = Point<2>;
    using P3 = Point<3>;
    CHECK(near(cloud_distance<2>(box<2>(P2(0, 0), P2(1, 1)), box<2>(P2(4, 5), P2(6, 6))), 5.0, kDouble));
    // Gaps of 2, 3 and 6 along the axes: sqrt(4 + 9 + 36) = 7.
    CHECK(near(cloud_distance<3>(box<3>(P3(0, 0, 0), P3(1, 1, 1)), box<3>(P3(3, 4, 7), P3(5, 5, 8))), 7.0, kDouble));
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
    CHECK(near(result.distance, 3.5, relative(1e-12)));
    CHECK(near(result.nearest.normalized().dot((center_a - center_b).normalized()), 1.0, relative(1e-12)));
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
