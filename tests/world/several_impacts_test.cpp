// Bodies that have several impacts in a step, and impacts that go on through touching bodies.
#include <doctest/doctest.h>

#include <cmath>

#include "support/discs.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Elastic discs in rows in a square box, each as fast, and each in another direction.
struct Gas {
    int columns, rows;
    float side, radius, speed;  // m, m, m/s
};
World make_gas(const Gas& gas) {
    World world = ordered();
    add_walls(world, gas.side, kElastic);
    for (int i = 0; i < gas.columns * gas.rows; ++i) {
        const double side = static_cast<double>(gas.side);
        const DVec2 at{side * ((i % gas.columns + 0.5) / gas.columns - 0.5),
                       side * ((i / gas.columns + 0.5) / gas.rows - 0.5)};
        const float angle = 2.4f * static_cast<float>(i);
        throw_disc(world, at, {gas.speed * std::cos(angle), gas.speed * std::sin(angle)}, kElastic, gas.radius);
    }
    return world;
}

}  // namespace

// A smooth disc has no torque: only the rounding of arms to float may turn it.
TEST_CASE("in order: smooth discs that have several impacts in a step keep their energy and do not spin") {
    World world = make_gas({19, 16, 10.0f, 0.1f, 100.0f});
    const double energy = kinetic_energy(world);
    for (int step = 0; step < 30; ++step) {
        world.step();
        for (const ContactBegin& begin : world.events().contact_begins)
            CHECK(near(length(DVec2(begin.normal)), 1.0, absolute(1e-6)));
    }
    CHECK(near(kinetic_energy(world), energy, relative(1e-6)));
    for (const BodyId id : world.bodies()) CHECK(std::abs(world.state(id).angular_velocity) < 0.1f);
}

TEST_CASE("in order: a gas keeps its energy for a minute, though bodies meet where no impact was foreseen") {
    for (const Gas gas : {Gas{5, 2, 20.0f, 0.5f, 40.0f}, Gas{5, 2, 8.0f, 0.25f, 5.0f}, Gas{5, 2, 4.0f, 0.12f, 80.0f},
                          Gas{7, 6, 4.0f, 0.12f, 5.0f}}) {
        CAPTURE(gas.speed);
        World world = make_gas(gas);
        const double energy = kinetic_energy(world);
        run(world, 3600);
        CHECK(near(kinetic_energy(world), energy, relative(1e-4)));
    }
}

// The passing disc touches the target when the step begins, but no longer at the impact.
TEST_CASE("in order: an impact does not go on through shapes that no longer touch") {
    for (const float spin : {0.0f, 30.0f}) {
        World world = ordered();
        const BodyId target = throw_disc(world, {0.0, 0.0}, {}, kElastic, 0.2f);
        const BodyId passing = throw_disc(world, {0.0, 0.4001}, {60.0f, 0.0f}, kElastic, 0.2f);
        throw_disc(world, {0.0, -1.3}, {0.0f, 60.0f}, kElastic, 0.2f);
        world.set_velocity(target, {}, spin);
        world.step();
        CHECK(length(world.state(passing).velocity - Vec2{60.0f, 0.0f}) < 1e-4f);
        CHECK(length(world.state(target).velocity - Vec2{0.0f, 60.0f}) < 1e-4f);
    }
}

// The last disc is 15 mm from the target at the impact, which sends the target past it at a distance of 1 mm.
TEST_CASE("in order: shapes that are near do not bounce before they touch") {
    World world = ordered();
    const BodyId target = throw_disc(world, {0.0, 0.0}, {}, kElastic, 0.1f);
    const BodyId last = throw_disc(world, {0.0, 0.201}, {5.0f, 0.0f}, kElastic, 0.1f);
    throw_disc(world, {-1.1, 0.0}, {60.0f, 0.0f}, kElastic, 0.1f);
    world.step();
    CHECK(length(world.state(target).velocity - Vec2{60.0f, 0.0f}) < 1e-4f);
    CHECK(length(world.state(last).velocity - Vec2{5.0f, 0.0f}) < 1e-4f);
}

TEST_CASE("in order: an impact through a disc that spins gives a smooth one no spin") {
    World world = ordered();
    const BodyId target = throw_disc(world, {0.0, 0.0}, {}, kElastic, 0.2f);
    const BodyId last = throw_disc(world, {0.0, 0.4001}, {}, kElastic, 0.2f);
    throw_disc(world, {0.0, -1.3}, {0.0f, 60.0f}, kElastic, 0.2f);
    world.set_velocity(target, {}, 20.0f);
    world.set_velocity(last, {}, -20.0f);
    world.step();
    CHECK(length(world.state(last).velocity - Vec2{0.0f, 60.0f}) < 1e-3f);
    CHECK(near(world.state(target).angular_velocity, 20.0, absolute(1e-3)));
    CHECK(near(world.state(last).angular_velocity, -20.0, absolute(1e-3)));
}
