// Impacts at one time: one point with friction exactly, and groups whose friction keeps the impulses from settling.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "dynamics/impacts/impact_group.hpp"
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

double kinetic_energy(const ImpactGroup& group) {
    double energy = 0.0;
    for (const ImpactBody& body : group.bodies) {
        const Twist v = body.velocity + body.change;
        if (body.inv_mass.x > 0.0) energy += 0.5 * v.linear.x * v.linear.x / body.inv_mass.x;
        if (body.inv_mass.y > 0.0) energy += 0.5 * v.linear.y * v.linear.y / body.inv_mass.y;
        if (body.inv_inertia > 0.0) energy += 0.5 * v.angular * v.angular / body.inv_inertia;
    }
    return energy;
}

ImpactPoint make_point(DVec2 normal, DVec2 arm, double friction) {
    ImpactPoint point;
    point.a = 0;
    point.b = 1;
    point.normal = normal;
    point.arm_b = arm;
    point.friction = friction;
    return point;
}

ImpactBody make_body(double inv_mass, double inv_inertia, Twist velocity) {
    ImpactBody body;
    body.inv_mass = {inv_mass, inv_mass};
    body.inv_inertia = inv_inertia;
    body.velocity = body.mean_velocity = velocity;
    body.reach = 1.0;
    return body;
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

TEST_CASE("a corner that hits a rough floor stops at once, whatever the lever") {
    // Both speeds of the point end: x = -A^-1 w, a closed form.
    for (const DVec2 arm : {DVec2{0.5, -0.5}, {0.5, -0.05}, {0.1, -1.0}, {-0.7, -0.2}}) {
        ImpactGroup group;
        group.bodies = {{}, make_body(1.0, 6.0, {{0.3, -5.0}, 2.0})};
        group.points = {make_point({0.0, 1.0}, arm, 20.0)};
        solve_impacts(group);
        const double a = 1.0 + 6.0 * arm.x * arm.x, b = 1.0 + 6.0 * arm.y * arm.y, c = -6.0 * arm.x * arm.y;
        const double w = -5.0 + 2.0 * arm.x, u = 0.3 - 2.0 * arm.y, determinant = a * b - c * c;
        const Twist& change = group.bodies[1].change;
        CHECK(near(change.linear.y, (c * u - b * w) / determinant, relative(1e-12)));
        CHECK(near(change.linear.x, (c * w - a * u) / determinant, relative(1e-12)));
        CHECK(group.work <= 2);
    }
}

TEST_CASE("a group that friction drives apart gains no energy") {
    // One body in six contacts with static shapes, with friction up to 0.93; it cannot move along y. With friction the
    // passes multiply its impulses.
    ImpactGroup group;
    group.depth = 2;
    group.bodies = {{}, make_body(0.0683072209, 0.249515399, {{9.5e-7, 0.0}, 0.0})};
    group.bodies[1].inv_mass.y = 0.0;
    group.points = {make_point({-0.200535148, -0.979686499}, {0.00143214206, 0.105234312}, 0.494852364),
                    make_point({-0.200535148, -0.979686499}, {-0.0792916734, -0.299897444}, 0.529240847),
                    make_point({-0.200535148, -0.979686499}, {-0.0286768831, -0.327455621}, 0.529240847),
                    make_point({-0.815478027, 0.578788042}, {-0.109257707, -0.0498351892}, 0.92720753),
                    make_point({-0.815478027, 0.578788042}, {-0.177112641, -0.0773766786}, 0.92720753),
                    make_point({-0.815478027, 0.578788042}, {0.202910198, -0.202591594}, 0.866960347)};
    const double before = kinetic_energy(group);
    solve_impacts(group);
    CHECK(kinetic_energy(group) <= before * (1.0 + 1e-9));
    CHECK(group.work < 2000);
}

TEST_CASE("a body that is crushed ends the rounds with finite impulses") {
    // Two immovable bodies approach a ball from both sides: no impulses end that.
    ImpactGroup group;
    group.bodies = {make_body(0.0, 0.0, {{10.0, 0.0}, 0.0}), make_body(1.0, 2.0, {}),
                    make_body(0.0, 0.0, {{-10.0, 0.0}, 0.0})};
    group.points = {make_point({1.0, 0.0}, {-1.0, 0.0}, 0.5), make_point({-1.0, 0.0}, {1.0, 0.0}, 0.5)};
    group.points[1].a = 2;
    solve_impacts(group);
    for (const ImpactPoint& point : group.points) {
        CHECK(point.normal_impulse >= 10.0);
        CHECK(point.normal_impulse < 1000.0);
    }
    CHECK(std::abs(group.bodies[1].change.linear.x) <= 10.0);
    CHECK(group.work < 200);
}
