// Impacts in the order of time (ImpactModel::in_order), against the laws of impact and free flight.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/discs.hpp"
#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// The speed along the floor after an oblique impact at 10 m/s down and 5 m/s along, for each phase of the step.
void check_oblique(float restitution, float friction) {
    const SurfaceMaterial material{.friction = friction, .restitution = restitution};
    for (int phase = 0; phase < 100; ++phase) {
        CAPTURE(phase);
        World world = ordered();
        add_floor(world, material);
        const double height = 0.5 + 10.0 / 60.0 * (1.0 + phase / 100.0);
        const BodyId disc = throw_disc(world, {0.0, height}, {5.0f, -10.0f}, material);
        run(world, 10);
        // Coulomb's law over the whole impulse m (1 + e) 10 m/s: the disc slips to the end.
        const double exact = 5.0 - static_cast<double>(friction * (1.0f + restitution)) * 10.0;
        CHECK(near(world.state(disc).velocity.x, exact, absolute(1e-4)));
    }
}

}  // namespace

TEST_CASE("in order: friction during an impact is mu times its impulse, at every phase of the step") {
    check_oblique(0.0f, 0.05f);
    check_oblique(0.5f, 0.1f);
}

TEST_CASE("in order: a ball that hits a ball at a wall comes back with its speed") {
    for (const float speed : {1.0f, 10.0f, 60.0f}) {
        World world = ordered();
        add_static(world, {5.0, 0.0}, make_box({1.0f, 10.0f}), kElastic);
        const BodyId target = throw_disc(world, {4.0, 0.0}, {}, kElastic);
        const BodyId ball = throw_disc(world, {2.0, 0.0}, {speed, 0.0f}, kElastic);
        run(world, 120);
        CHECK(near(world.state(ball).velocity.x, -double{speed}, relative(1e-6)));
        CHECK(std::abs(world.state(target).velocity.x) < 1e-5f * speed);
    }
}

TEST_CASE("in order: a row of touching balls passes an impact on to its last ball") {
    World world = ordered();
    std::vector<BodyId> row;
    for (int i = 0; i < 5; ++i) row.push_back(throw_disc(world, {i == 0 ? -3.0 : i, 0.0}, {}, kElastic));
    world.set_velocity(row.front(), {1.0f, 0.0f}, 0.0f);
    run(world, 240);
    for (int i = 0; i < 4; ++i) CHECK(std::abs(world.state(row[static_cast<std::size_t>(i)]).velocity.x) < 1e-6f);
    CHECK(near(world.state(row.back()).velocity.x, 1.0, relative(1e-6)));
}

TEST_CASE("in order: as many balls leave a row of touching balls as hit it") {
    for (const int count : {1, 2, 3}) {
        CAPTURE(count);
        World world = ordered();
        std::vector<BodyId> balls;
        for (int i = 0; i < 7; ++i) {
            const bool flies = i < count;
            balls.push_back(throw_disc(world, {i - (flies ? 1.0 : 0.0), 0.0}, {flies ? 3.0f : 0.0f, 0.0f}, kElastic));
        }
        run(world, 60);
        for (int i = 0; i < 7; ++i)
            CHECK(near(world.state(balls[static_cast<std::size_t>(i)]).velocity.x, i < 7 - count ? 0.0 : 3.0,
                       absolute(1e-5)));
    }
}

TEST_CASE("in order: an elastic gas without gravity keeps its energy") {
    World world = ordered();
    add_walls(world, 20.0f, kElastic);
    for (int i = 0; i < 10; ++i) {
        const double angle = 0.7 + 0.61 * i;
        throw_disc(world, {-7.0 + 3.5 * (i % 5), -3.0 + 6.0 * (i / 5)},
                   {static_cast<float>(15.0 * std::cos(angle)), static_cast<float>(15.0 * std::sin(angle))}, kElastic);
    }
    const double start = kinetic_energy(world);
    run(world, 1200);
    CHECK(near(kinetic_energy(world), start, relative(1e-5)));
}

TEST_CASE("in order: bounces between two walls keep their times") {
    for (const float speed : {20.0f, 50.0f, 200.0f}) {
        CAPTURE(speed);
        World world = ordered();
        add_walls(world, 4.0f, kElastic);
        const BodyId ball = throw_disc(world, {}, {speed, 0.0f}, kElastic, 0.1f);
        constexpr int steps = 90;
        run(world, steps);
        // Its path, folded between the walls: 3.8 m apart for the centre.
        const double path = double{speed} * steps / 60.0 + 1.9, rest = std::fmod(path, 7.6);
        const double exact = rest < 3.8 ? rest - 1.9 : 5.7 - rest;
        CHECK(near(world.state(ball).pose.position.x, exact, absolute(1e-3)));
    }
}

TEST_CASE("in order: a disc lands without overlap, at any speed and phase of the step") {
    for (const double speed : {5.0, 20.0, 29.0})
        for (int phase = 0; phase < 20; ++phase) {
            World world = ordered();
            add_floor(world);
            const double height = 0.5 + speed / 60.0 * (1.0 + phase / 20.0);
            const BodyId disc = throw_disc(world, {0.0, height}, {0.0f, static_cast<float>(-speed)}, {});
            for (int step = 0; step < 6; ++step) {
                world.step();
                CHECK(world.state(disc).pose.position.y > 0.49);
            }
        }
}

TEST_CASE("in order: a kinematic paddle takes every resting ball along") {
    for (const float speed : {25.0f, 100.0f})
        for (int phase = 0; phase < 30; ++phase) {
            World world = ordered();
            const double start = -3.0 - static_cast<double>(speed) / 60.0 * phase / 30.0;
            const BodyId paddle = add_body(world, BodyType::kinematic_body, {start, 0.0}, make_box({0.2f, 2.0f}));
            world.set_velocity(paddle, {speed, 0.0f}, 0.0f);
            const BodyId ball = throw_disc(world, {}, {}, {}, 0.1f);
            run(world, 20);
            CHECK(world.state(ball).pose.position.x > world.state(paddle).pose.position.x);
        }
}

TEST_CASE("in order: a ball bounces off a moving kinematic body as off one at rest") {
    // Its speed against the plate is reversed: 2 u - v.
    for (const float plate_speed : {-3.0f, 0.0f, 5.0f, 10.0f})
        for (const float ball_speed : {-5.0f, 0.0f, 2.0f}) {
            if (ball_speed >= plate_speed) continue;
            CAPTURE(plate_speed);
            CAPTURE(ball_speed);
            World world = ordered();
            const BodyId plate = add_body(world, BodyType::kinematic_body, {0.0, -1.0}, make_box({4.0f, 0.5f}));
            world.set_velocity(plate, {0.0f, plate_speed}, 0.0f);
            const BodyId ball =
                throw_disc(world, {}, {0.0f, ball_speed}, {.friction = 0.0f, .restitution = 1.0f}, 0.1f);
            run(world, 90);
            CHECK(near(world.state(ball).velocity.y, 2.0f * plate_speed - ball_speed, relative(1e-5)));
        }
}

TEST_CASE("in order: a belt does not weaken the bounce of what falls on it") {
    const auto rebound = [](float belt_speed) {
        World world = ordered({0.0f, -10.0f});
        SurfaceMaterial belt{.friction = 0.5f, .restitution = 0.8f};
        belt.tangent_speed = belt_speed;
        add_static(world, {0.0, -0.5}, make_box({200.0f, 1.0f}), belt);
        const BodyId ball = throw_disc(world, {0.0, 3.0}, {}, {.friction = 0.5f, .restitution = 0.8f}, 0.5f);
        float fastest = 0.0f;
        for (int step = 0; step < 60; ++step) {
            world.step();
            fastest = std::max(fastest, world.state(ball).velocity.y);
        }
        return fastest;
    };
    const float at_rest = rebound(0.0f);
    CHECK(at_rest > 5.0f);
    for (const float speed : {-20.0f, 2.0f, 10.0f, 20.0f}) CHECK(near(rebound(speed), at_rest, relative(1e-3)));
}

TEST_CASE("in order: ten boxes that land as one stack do not rebound") {
    World world = ordered({0.0f, -10.0f});
    add_floor(world);
    std::vector<BodyId> stack;
    for (int i = 0; i < 10; ++i) stack.push_back(add_dynamic(world, {0.0, 5.53 + i}, make_box({1.0f, 1.0f})));
    float fastest = 0.0f;
    for (int step = 0; step < 150; ++step) {
        world.step();
        for (const BodyId box : stack) fastest = std::max(fastest, world.state(box).velocity.y);
    }
    CHECK(fastest < 1.0f);
}

TEST_CASE("in order: twenty stacks that land at different times do not rebound, nor does a stack of twenty boxes") {
    World world = ordered({0.0f, -10.0f});
    add_static(world, {40.0, -0.5}, make_box({200.0f, 1.0f}));
    std::vector<BodyId> boxes;
    const auto add_stack = [&](double x, double height, int count) {
        for (int i = 0; i < count; ++i) boxes.push_back(add_dynamic(world, {x, height + i}, make_box({1.0f, 1.0f})));
    };
    // 0.0085 m: 20 stacks at 20 phases of a step, 0.17 m at 10 m/s.
    for (int stack = 0; stack < 20; ++stack) add_stack(4.0 * stack, 5.5 + 0.0085 * stack, 10);
    add_stack(-4.0, 5.5, 20);
    float fastest = 0.0f;
    for (int step = 0; step < 120; ++step) {
        world.step();
        for (const BodyId box : boxes) fastest = std::max(fastest, world.state(box).velocity.y);
    }
    CHECK(fastest < 1.0f);
}

TEST_CASE("in order: shapes that pass each other within a step do not touch") {
    // The boxes pass a ledge at gaps from 1 mm to 5 cm, and fall by a third of a metre in a step.
    for (const double gap : {0.001, 0.01, 0.05}) {
        CAPTURE(gap);
        World world = ordered({0.0f, -10.0f});
        add_static(world, {-1.0, 0.0}, make_box({2.0f, 2.0f}));
        const BodyId box = add_dynamic(world, {0.25 + gap, 2.0}, make_box({0.5f, 0.5f}));
        world.set_velocity(box, {0.0f, -20.0f}, 0.0f);
        for (int step = 0; step < 20; ++step) {
            world.step();
            CHECK(world.events().contact_begins.empty());
        }
        CHECK(world.state(box).velocity.x == 0.0f);
        CHECK(world.state(box).pose.position.y < -3.0);
    }
}

TEST_CASE("in order: a velocity that the caller sets counts in the same step") {
    World world = ordered();
    add_static(world, {2.0, 0.0}, make_box({0.5f, 4.0f}));
    const BodyId disc = add_dynamic(world, {0.0, 0.0}, make_circle(0.1f));
    run(world, 3);
    world.set_velocity(disc, {200.0f, 0.0f}, 0.0f);
    world.step();
    // Its surface is at the wall: 2 m less half of the wall and the radius.
    CHECK(near(world.state(disc).pose.position.x, 1.65, absolute(1e-4)));
    CHECK(world.state(disc).velocity.x <= 0.0f);
}

TEST_CASE("in order: a turning rod strikes what its tip reaches within the step") {
    World world = ordered();
    const BodyId rod = add_body(world, BodyType::kinematic_body, {0.0, 0.0}, make_box({4.0f, 0.1f}));
    const BodyId disc = add_dynamic(world, {std::cos(0.5) * 1.9, std::sin(0.5) * 1.9}, make_circle(0.05f));
    run(world, 3);
    world.set_velocity(rod, {}, 36.0f);  // 0.6 rad in a step
    world.step();
    // An inelastic impact gives it the speed of the rod's point 1.9 m from the axis.
    CHECK(near(length(world.state(disc).velocity), 1.9 * 36.0, relative(0.05)));
}

TEST_CASE("in order: a pile of bouncing discs comes to rest") {
    World world = ordered({0.0f, -10.0f});
    const SurfaceMaterial rubber{.friction = 0.5f, .restitution = 0.6f};
    add_walls(world, 6.0f, rubber);
    std::vector<BodyId> discs;
    for (int i = 0; i < 40; ++i)
        discs.push_back(add_dynamic(world, {-2.2 + 0.6 * (i % 8) + 0.01 * (i / 8), -2.5 + 0.7 * (i / 8)},
                                    make_circle(0.25f), rubber));
    run(world, 8 * 60);
    for (const BodyId disc : discs) CHECK(length(world.state(disc).velocity) < 0.05f);
}

TEST_CASE("in order: a projectile follows its parabola, and with damping its closed form, at any rate") {
    for (const float rate : {60.0f, 240.0f, 1920.0f})
        for (const double damping : {0.0, 0.5, 30.0}) {
            CAPTURE(rate);
            CAPTURE(damping);
            WorldDef def;
            def.steps_per_second = rate;
            def.impacts = ImpactModel::in_order;
            World world(def);
            const BodyId ball = throw_disc(world, {}, {10.0f, 20.0f}, {});
            world.set_damping(ball, static_cast<float>(damping), 0.0f);
            constexpr double t = 3.0;
            run(world, static_cast<int>(t * static_cast<double>(rate)));
            // With v' = a - c v: x = v gain + a (t - gain) / c, where gain = (1 - e^-ct) / c.
            const double gain = damping > 0.0 ? (1.0 - std::exp(-damping * t)) / damping : t;
            const double fall = damping > 0.0 ? (t - gain) / damping : 0.5 * t * t;
            const DVec2 position = world.state(ball).pose.position;
            CHECK(near(position.x, 10.0 * gain, absolute(1e-4)));
            CHECK(near(position.y, 20.0 * gain - 10.0 * fall, absolute(1e-4)));
        }
}

TEST_CASE("in order: a saved world goes on bit for bit") {
    World world = ordered({0.0f, -10.0f});
    add_walls(world, 6.0f, kElastic);
    for (int i = 0; i < 8; ++i) {
        const float size = static_cast<float>(i);
        throw_disc(world, {0.6 * i - 2.1, 0.3 * i - 1.0}, {3.0f - size, 2.0f * size}, kElastic, 0.2f);
    }
    run(world, 30);
    World loaded = World::load(world.save());
    run(world, 60);
    run(loaded, 60);
    CHECK(loaded.state_hash() == world.state_hash());
}

// Its normal goes through the centre, up to rounding: no impulse along it moves the disc, however large.
TEST_CASE("in order: a disc that may only turn keeps its spin when a platform runs into it") {
    for (int turn = 0; turn < 20; ++turn) {
        CAPTURE(turn);
        World world = ordered();
        const double angle = 0.1 * turn;
        const DVec2 down{std::sin(angle), -std::cos(angle)};
        const BodyId platform =
            add_body(world, BodyType::kinematic_body, 1.5 * down, make_box({4.0f, 1.0f}), kElastic, angle);
        world.set_velocity(platform, to_float(-10.0 * down), 0.0f);
        BodyDef def;
        def.locks = {.x = true, .y = true};
        const BodyId disc = world.create_body(def);
        world.add_shape(disc, {make_circle(0.5f), {.friction = 1.0f, .restitution = 1.0f}});
        world.set_velocity(disc, {}, 3.0f);
        run(world, 10);
        CHECK(near(world.state(disc).angular_velocity, 3.0, kFloat));
    }
}
