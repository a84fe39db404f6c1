// The impulse of one point with friction, against the roots of its piecewise linear speed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "dynamics/impacts/point_impulse.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct PointCase {
    PointResponse response;
    double normal_speed, tangent_speed, friction;
};

// The normal speed after the normal impulse x and Coulomb's tangential impulse for it.
double normal_speed_after(const PointCase& c, double x) {
    const double bound = c.friction * x;
    const double tangent = std::clamp(-(c.tangent_speed + c.response.coupling * x) / c.response.tangent, -bound, bound);
    return c.normal_speed + c.response.normal * x + c.response.coupling * tangent;
}

// The first root of a function of straight pieces, from all points where a clamp can begin or end.
double first_root(const PointCase& c) {
    std::vector<double> ends{0.0};
    for (const double side : {-1.0, 1.0})
        if (const double x = -c.tangent_speed / (c.response.coupling + side * c.friction * c.response.tangent); x > 0.0)
            ends.push_back(x);
    std::ranges::sort(ends);
    ends.push_back(2.0 * ends.back() + 1.0);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double from = normal_speed_after(c, ends[i]), to = normal_speed_after(c, ends[i + 1]);
        const bool is_last = i + 2 == ends.size();
        if (to >= 0.0 || (is_last && to > from)) return ends[i] - from * (ends[i + 1] - ends[i]) / (to - from);
    }
    return -1.0;
}

}  // namespace

TEST_CASE("the impulse of a point with friction is the first that stops the approach") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int sliding = 0, holding = 0;
    for (int i = 0; i < 100'000; ++i) {
        PointCase c;
        c.response.normal = std::exp(4.0 * unit(random) - 2.0);
        c.response.tangent = std::exp(4.0 * unit(random) - 2.0);
        c.response.coupling = 0.999 * (2.0 * unit(random) - 1.0) * std::sqrt(c.response.normal * c.response.tangent);
        c.normal_speed = -std::exp(4.0 * unit(random) - 2.0);
        c.tangent_speed = i % 10 == 0 ? 0.0 : 8.0 * unit(random) - 4.0;
        c.friction = 3.0 * unit(random);
        const double x = find_point_impulse(c.response, c.normal_speed, c.tangent_speed, c.friction);
        CHECK(near(x, first_root(c), {1e-7, 1e-9}));
        CHECK(near(normal_speed_after(c, x), 0.0, {1e-9, 0.0}));
        const double held = -(c.tangent_speed + c.response.coupling * x) / c.response.tangent;
        ++(std::abs(held) < c.friction * x ? holding : sliding);
    }
    CHECK(sliding > 10'000);
    CHECK(holding > 10'000);
}

TEST_CASE("a point that is not approached gets no impulse, and one that jams that without friction") {
    CHECK(find_point_impulse({2.0, 1.0, 0.5}, 0.0, 1.0, 0.5) == 0.0);
    CHECK(find_point_impulse({2.0, 1.0, 0.5}, 3.0, 1.0, 0.5) == 0.0);
    // A body that moves along one axis only, pushed into a wedge: a b = c^2, and the friction exceeds c / b.
    CHECK(find_point_impulse({0.25, 1.0, 0.5}, -3.0, 4.0, 0.6) == 12.0);
}

TEST_CASE("at the boundary of sliding and holding rounding does not change the impulse") {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 20'000; ++i) {
        // Arms and a friction that are exact in binary, so that friction * tangent and the coupling are equal.
        PointCase c{{2.5, 2.5, i % 2 == 0 ? 1.5 : -1.5}, -20.0 * unit(random), 0.0, 0.6};
        if (i % 3 == 0) c = {{2.5, 2.5, 1.5}, -4.4, -5.2, 2.0};
        // Sliding that stops just when the approach does.
        if (i % 3 == 1) {
            const double x = 10.0 * unit(random), direction = i % 2 == 0 ? 1.0 : -1.0;
            c.friction = 0.4 + 2.0 * unit(random);
            c.tangent_speed = -x * (c.response.coupling + direction * c.friction * c.response.tangent);
            c.normal_speed = -x * (c.response.normal + direction * c.friction * c.response.coupling);
            if (c.normal_speed > 0.0 || c.tangent_speed * direction > 0.0) continue;
        }
        const double x = find_point_impulse(c.response, c.normal_speed, c.tangent_speed, c.friction);
        CHECK(near(normal_speed_after(c, x), 0.0, absolute(1e-12 * (1.0 - c.normal_speed))));
    }
}
