// Impacts at one time whose friction keeps the impulses from settling, and those that have no solution.
#include <doctest/doctest.h>

#include <cmath>

#include "dynamics/impacts/impact_group.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

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

TEST_CASE("friction that jams a body in a wedge is dropped") {
    // The body moves along x only, and a wedge of 45 degrees rises under it: without friction it slides off at 5 m/s.
    const double half = std::sqrt(0.5);
    ImpactGroup group;
    group.bodies = {make_body(0.0, 0.0, {{0.0, 5.0}, 0.0}), make_body(1.0, 0.0, {})};
    group.bodies[1].inv_mass.y = 0.0;
    group.points = {make_point({half, half}, {}, 1.2)};
    solve_impacts(group);
    CHECK(near(group.bodies[1].change.linear.x, 5.0, relative(1e-12)));
    CHECK(near(group.points[0].normal_impulse, 5.0 / half, relative(1e-12)));
    CHECK(group.work < 100);
}
