// The drive of a joint, and the angle that it acts on.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_drive.hpp"
#include "support/random_numbers.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A position of which the drive gets bounds first.
struct BoundedPosition {
    float value;
    PositionRange bounds;
    int* asked;

    float now() const {
        ++*asked;
        return value;
    }
    PositionRange range() const { return bounds; }
};

JointDrive random_drive(RandomNumbers& random) {
    const float lower = random.between(-1.0f, 0.5f);
    std::optional<JointSpring> spring;
    std::optional<DriveMotor> motor;
    if (random.between(0.0f, 1.0f) < 0.2f) spring = JointSpring{random.between(1.0f, 5.0f), random.between(0.0f, 1.0f)};
    if (random.coin()) motor = DriveMotor{random.between(-20.0f, 20.0f), random.between(0.0f, 50.0f)};
    return {spring, motor, JointLimits{lower, lower + random.between(0.0f, 1.5f)}};
}

JointBodies random_joint(RandomNumbers& random) {
    JointBodies joint;
    joint.a = 1;
    joint.b = 2;
    joint.inv_inertia_a = random.coin() ? random.between(0.1f, 10.0f) : 0.0f;
    joint.inv_inertia_b = random.between(0.1f, 10.0f);
    joint.inv_mass_a = joint.inv_mass_b = {1.0f, 1.0f};
    return joint;
}

JointRow random_linear_row(RandomNumbers& random) {
    return point_row({1.0f, 0.0f}, {random.between(-1.0f, 1.0f), 1.0f}, {0.5f, random.between(-1.0f, 1.0f)});
}

std::array<SolverBody, 3> random_bodies(RandomNumbers& random) {
    std::array<SolverBody, 3> bodies;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        bodies[i].velocity = {random.between(-3.0f, 3.0f), random.between(-3.0f, 3.0f)};
        bodies[i].angular_velocity = random.between(-10.0f, 10.0f);
    }
    return bodies;
}

bool equal_velocities(const std::array<SolverBody, 3>& a, const std::array<SolverBody, 3>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].velocity != b[i].velocity || a[i].angular_velocity != b[i].angular_velocity) return false;
    return true;
}

constexpr float kHz = 240.0f;
const JointContext kContext{1.0f / kHz, kHz, joint_softness(make_tuning(1.0f, {}, 1.0f / 60.0f), 1.0f / kHz)};

}  // namespace

TEST_CASE("a drive that has bounds of its position acts as one that knows it, and seldom asks for it") {
    RandomNumbers random(1);
    int asked = 0, solved = 0, pushed = 0;
    const auto compare = [&](const auto& row) {
        JointDrive known = random_drive(random);
        JointDrive bounded = known;
        const JointBodies joint = random_joint(random);
        std::array<SolverBody, 3> bodies = random_bodies(random);
        const float value = random.between(-0.8f, 1.0f);
        for (int pass = 0; pass < 4; ++pass) {
            const float width = random.between(0.0f, 0.1f);
            const BoundedPosition position{value, {value - width, value + random.between(0.0f, 0.1f)}, &asked};
            std::array<SolverBody, 3> same = bodies;
            known.solve(joint, row, KnownPosition{value}, 0.0f, kContext, pass % 2 == 0, bodies);
            bounded.solve(joint, row, position, 0.0f, kContext, pass % 2 == 0, same);
            ++solved;
            pushed += known.impulse() != 0.0f;
            REQUIRE(equal_velocities(bodies, same));
            REQUIRE(known.impulse() == bounded.impulse());
        }
    };
    for (int i = 0; i < 10000; ++i) {
        compare(kAngularRow);
        compare(random_linear_row(random));
    }
    CHECK(pushed > solved / 4);
    CHECK(asked < 3 * solved / 4);
}

TEST_CASE("the angular row acts as a row without an axis") {
    RandomNumbers random(5);
    const JointRow row = kAngularRow;
    for (int i = 0; i < 10000; ++i) {
        const JointBodies joint = random_joint(random);
        std::array<SolverBody, 3> bodies = random_bodies(random);
        std::array<SolverBody, 3> same = bodies;
        REQUIRE(row_mass(joint, kAngularRow) == row_mass(joint, row));
        REQUIRE(row_velocity(joint, kAngularRow, bodies) == row_velocity(joint, row, bodies));
        const float impulse = random.between(-5.0f, 5.0f);
        apply_row(joint, kAngularRow, impulse, bodies);
        apply_row(joint, row, impulse, same);
        REQUIRE(equal_velocities(bodies, same));
    }
}

TEST_CASE("a limit that may not be reached has no impulse") {
    RandomNumbers random(2);
    int left = 0, reached = 0;
    for (int i = 0; i < 20000; ++i) {
        const JointBodies joint = random_joint(random);
        const JointRow row = random_linear_row(random);
        const float side = random.coin() ? 1.0f : -1.0f, gap = random.between(-0.005f, 0.03f);
        std::array<SolverBody, 3> bodies = random_bodies(random);
        const std::array<SolverBody, 3> before = bodies;
        float impulse = 0.0f;
        const bool may_reach = may_reach_limit(joint, row, side, gap, kContext, impulse, bodies);
        solve_limit(joint, row, side, gap, kContext, true, impulse, bodies);
        (may_reach ? reached : left) += 1;
        if (!may_reach) REQUIRE((impulse == 0.0f && equal_velocities(bodies, before)));
    }
    CHECK(left > 6000);
    CHECK(reached > 6000);
}

TEST_CASE("the range of a joint angle contains it") {
    RandomNumbers random(3);
    int narrow = 0;
    for (int i = 0; i < 20000; ++i) {
        BodyFrame a, b;
        a.pose.rotation = make_rotation(random.between(-4.0f, 4.0f));
        b.pose.rotation = make_rotation(random.between(-4.0f, 4.0f));
        JointAngle angle;
        angle.prepare(a, b, random.between(-3.0f, 3.0f));
        const float size = std::pow(10.0f, random.between(-9.0f, 0.5f));
        std::array<SolverBody, 3> bodies;
        for (SolverBody* const body : {&bodies[1], &bodies[2]})
            body->delta_rotation = make_rotation(size * random.between(-1.0f, 1.0f));
        const JointBodies joint = random_joint(random);
        const PositionRange range = angle.range(joint, bodies);
        const float now = angle.now(joint, bodies);
        REQUIRE(range.lower <= now);
        REQUIRE(now <= range.upper);
        narrow += range.upper - range.lower < 0.1f;
    }
    CHECK(narrow > 10000);
}

TEST_CASE("the turn of a joint is the arc tangent to float precision") {
    RandomNumbers random(4);
    for (int i = 0; i < 20000; ++i) {
        const double t = static_cast<double>(random.between(-0.125f, 0.125f));
        REQUIRE(std::abs(small_arc_tangent(t) - arc_tangent(t, 1.0)) <= 3e-14 * std::abs(t));
        const Rotation from = make_rotation(random.between(-4.0f, 4.0f));
        const Rotation to = compose(make_rotation(random.between(-0.2f, 0.2f)), from);
        const float exact = static_cast<float>(relative_angle(from, to));
        REQUIRE(std::abs(relative_turn(from, to) - exact) <= 6e-8f * std::abs(exact));
    }
    CHECK(relative_turn({0.0f, 0.0f}, {1.0f, 0.0f}) == 0.0f);
    CHECK(std::isnan(relative_turn({1.0f, 0.0f}, {1.0f, std::numeric_limits<float>::infinity()})));
}
