// Joints against the mechanics of pendulums and rods.
#include <doctest/doctest.h>

#include <cmath>

#include "support/near.hpp"
#include "support/pendulum.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;

// The time between the first and the third crossing of x = 0, interpolated.
double measured_period(World& world, BodyId bob) {
    double first = -1.0, before = world.state(bob).pose.position.x;
    int passages = 0;
    for (int step = 1; step < 6000; ++step) {
        world.step();
        const double now = world.state(bob).pose.position.x;
        if ((before > 0.0) != (now > 0.0)) {
            const double time = (step - now / (now - before)) / 60.0;
            ++passages;
            if (passages == 1) first = time;
            if (passages == 3) return time - first;
        }
        before = now;
    }
    return -1.0;
}

struct Pendulum {
    World world;
    BodyId pivot;
    BodyId bob;
};

// A ball on a massless arm of 2 m, let go at an angle from the lowest point.
Pendulum make_pendulum(double amplitude, float radius) {
    Pendulum p;
    p.pivot = p.world.create_body({.type = BodyType::static_body});
    p.bob = add_dynamic(p.world, {2.0 * std::sin(amplitude), -2.0 * std::cos(amplitude)}, make_circle(radius), {},
                        amplitude);
    return p;
}

}  // namespace

TEST_CASE("a pendulum on a revolute joint swings with the elliptic period") {
    for (const double amplitude : {0.3, 1.2, 2.4}) {
        constexpr float radius = 0.25f;
        Pendulum p = make_pendulum(amplitude, radius);
        p.world.create_joint(RevoluteJointDef{.body_a = p.pivot, .body_b = p.bob, .anchor_b = {0.0f, 2.0f}});
        // The ball rotates with the arm: L = I / (m d) with I = m r^2 / 2 + m d^2.
        const double length = (radius * radius / 2.0 + 4.0) / 2.0;
        // Passages are interpolated linearly in a step, to 1e-5; the scheme errs by (w h)^2 / 24, far less. The joint
        // yields to the centrifugal force by up to 4.5 g / (2 pi 60)^2 = 0.3 mm, and takes some of the swing's
        // energy.
        CHECK(near(measured_period(p.world, p.bob), pendulum_period(length, amplitude), relative(5e-4)));
    }
}

TEST_CASE("a point mass on a distance joint swings with the elliptic period") {
    Pendulum p = make_pendulum(1.0, 0.05f);
    p.world.create_joint(DistanceJointDef{.body_a = p.pivot, .body_b = p.bob, .length = 2.0f});
    CHECK(near(measured_period(p.world, p.bob), pendulum_period(2.0, 1.0), relative(5e-4)));
    // Taut by at most m (g + v^2 / L) < 3 m g: the soft joint yields by 3 g / (2 pi 60)^2 = 0.2 mm. A sub-step along
    // the tangent leaves the circle by (v h)^2 / (2 L) = 0.1 mm more, of which the next takes back a part.
    CHECK(near(length(p.world.state(p.bob).pose.position), 2.0, absolute(0.0005)));
}

TEST_CASE("a pendulum keeps its height for a minute") {
    Pendulum p = make_pendulum(1.0, 0.25f);
    p.world.create_joint(RevoluteJointDef{.body_a = p.pivot, .body_b = p.bob, .anchor_b = {0.0f, 2.0f}});
    const double start = p.world.state(p.bob).pose.position.y;
    double highest = -10.0;
    for (int step = 0; step < 3600; ++step) {
        p.world.step();
        if (step > 3000) highest = std::max(highest, p.world.state(p.bob).pose.position.y);
    }
    CHECK(highest < start + 0.01);
    CHECK(highest > start - 0.05);
}

TEST_CASE("the reaction of a joint is the weight of the body that hangs on it") {
    Pendulum p = make_pendulum(0.0, 0.5f);
    const JointId joint =
        p.world.create_joint(RevoluteJointDef{.body_a = p.pivot, .body_b = p.bob, .anchor_b = {0.0f, 2.0f}});
    run(p.world, 120);
    const double weight = kGravity * p.world.mass(p.bob).mass;
    CHECK(near(p.world.reaction(joint).force.y, weight, kFloat));
    CHECK(std::abs(p.world.reaction(joint).force.x) < 0.001 * weight);
    // A hinge with its softness would open by g / w^2 = 7e-5 m. This one is rigid, as the bob has no other joint. Its
    // positions of 2 m are floats.
    CHECK(near(-p.world.state(p.bob).pose.position.y, 2.0, absolute(2.0 * 0x1p-23)));
}

TEST_CASE("a dumbbell that flies and spins keeps its momentum and angular momentum") {
    World world = weightless();
    const BodyId a = add_dynamic(world, {-1.0, 0.0}, make_circle(0.3f), {.density = 2.0f});
    const BodyId b = add_dynamic(world, {1.0, 0.0}, make_box({0.4f, 0.6f}), {.density = 5.0f});
    world.create_joint(RevoluteJointDef{.body_a = a, .body_b = b, .anchor_a = {1.0f, 0.0f}, .anchor_b = {-1.0f, 0.0f}});
    world.set_velocity(a, {1.0f, -3.0f}, 0.5f);
    world.set_velocity(b, {0.0f, 2.0f}, -1.0f);
    struct Sums {
        DVec2 linear;
        double angular = 0.0;
    };
    const auto sums = [&] {
        Sums total;
        for (const BodyId id : {a, b}) {
            const BodyState state = world.state(id);
            const BodyMass mass = world.mass(id);
            const DVec2 momentum = double{mass.mass} * DVec2(state.velocity);
            total.linear += momentum;
            total.angular += cross(state.pose.position, momentum) +
                             double{mass.inertia} * static_cast<double>(state.angular_velocity);
        }
        return total;
    };
    const Sums before = sums();
    run(world, 600);
    const Sums after = sums();
    // 600 steps of 12 impulses: each is added to both bodies with opposite rounding errors of up to half an ulp.
    const double rounding = 600 * 12 * 0x1p-24 * 4.0;
    CHECK(length(after.linear - before.linear) < rounding);
    // The joint's anchors part by its softness, so that the two impulses act along lines that far apart.
    CHECK(near(after.angular, before.angular, relative(0.001)));
}

TEST_CASE("connected bodies collide only with collide_connected") {
    for (const bool collide : {false, true}) {
        World world = weightless();
        const BodyId a = add_dynamic(world, {0.0, 0.0}, make_box({1.0f, 1.0f}));
        const BodyId b = add_dynamic(world, {0.9, 0.0}, make_box({1.0f, 1.0f}));
        world.step();
        CHECK(world.contacts().size() == 2);
        const JointId joint = world.create_joint(RevoluteJointDef{.body_a = a,
                                                                  .body_b = b,
                                                                  .anchor_a = {0.45f, 0.0f},
                                                                  .anchor_b = {-0.45f, 0.0f},
                                                                  .collide_connected = collide});
        world.step();
        CHECK(world.contacts().empty() == !collide);
        world.destroy_joint(joint);
        world.step();
        CHECK(world.contacts().size() == 2);
        world.audit();
    }
}
