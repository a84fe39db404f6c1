// The same scene at several sizes: with the step scaled by the root of the size, all motions are similar.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A stack, a ball that bounces on it, a pendulum with a limit, a spring and a box on a slope: all lengths times
// `scale`.
World make_scene(float scale) {
    WorldDef def;
    def.scale = scale;
    def.steps_per_second = 60.0f / std::sqrt(scale);
    World world(def);
    const double s = scale;
    const auto box = [&](float width, float height) { return make_box({scale * width, scale * height}); };
    const BodyId floor = add_static(world, {0.0, -s}, box(200.0f, 2.0f));
    for (int i = 0; i < 5; ++i) add_dynamic(world, {0.0, s * (0.5 + i)}, box(1.0f, 1.0f));
    add_dynamic(world, {0.125 * s, 8.0 * s}, make_circle(0.5f * scale), {.restitution = 0.5f});
    const BodyId bob =
        add_dynamic(world, {6.0 * s, 4.0 * s}, make_capsule({-scale, 0.0f}, {scale, 0.0f}, 0.25f * scale));
    world.create_joint(RevoluteJointDef{.body_a = floor,
                                        .body_b = bob,
                                        .anchor_a = {5.0f * scale, 5.0f * scale},
                                        .anchor_b = {-scale, 0.0f},
                                        .limits = JointLimits{-1.0f, 1.0f}});
    const BodyId hung = add_dynamic(world, {-6.0 * s, 4.0 * s}, box(0.5f, 0.5f));
    world.create_joint(DistanceJointDef{.body_a = floor,
                                        .body_b = hung,
                                        .anchor_a = {-6.0f * scale, 7.0f * scale},
                                        .length = 2.0f * scale,
                                        .spring = JointSpring{2.0f / std::sqrt(scale), 0.25f}});
    const BodyId slope = add_static(world, {15.0 * s, 2.0 * s}, box(8.0f, 0.5f), {.friction = 0.25f}, 0.25);
    const Rotation tilt = world.state(slope).pose.rotation;
    add_dynamic(world, world.state(slope).pose.position + rotate(tilt, DVec2{s, 0.75 * s}), box(1.0f, 1.0f),
                {.friction = 0.25f}, 0.25);
    return world;
}

}  // namespace

// Every formula of the step is a product of powers of length and time: with a size of 4^k, whose root is a power of
// two, no rounding differs.
TEST_CASE("a world 64 times as large or as small moves the same, bit for bit") {
    for (const float scale : {64.0f, 1.0f / 64.0f}) {
        CAPTURE(scale);
        World plain = make_scene(1.0f), scaled = make_scene(scale);
        const double s = scale;
        const float root = std::sqrt(scale);
        for (int step = 0; step < 400; ++step) {
            CAPTURE(step);
            plain.step();
            scaled.step();
            for (const BodyId id : plain.bodies()) {
                const BodyState here = plain.state(id), there = scaled.state(id);
                REQUIRE(there.pose.position == s * here.pose.position);
                REQUIRE(there.pose.rotation == here.pose.rotation);
                REQUIRE(there.velocity == root * here.velocity);
                REQUIRE(plain.is_awake(id) == scaled.is_awake(id));
            }
        }
        CHECK(plain.counters().sleeping_islands > 0);
    }
}

// Without chaos, sizes that round differently differ by rounding only: 400 steps of half an ulp of float
// velocities of 10 m/s make 400 x 5e-7 m/s x 1/60 s = 3e-6 m, a contact that begins a step later 0.1 m/s x 1/60 s.
TEST_CASE("a world at 1/50 or 50 times the size settles at the same poses") {
    constexpr double kTolerance = 0.002;  // m at scale 1
    for (const float scale : {50.0f, 0.02f}) {
        CAPTURE(scale);
        World plain = make_scene(1.0f), scaled = make_scene(scale);
        run(plain, 600);
        run(scaled, 600);
        for (const BodyId id : plain.bodies()) {
            CAPTURE(id.index);
            const DVec2 here = plain.state(id).pose.position, there = (1.0 / scale) * scaled.state(id).pose.position;
            CHECK(std::abs(there.x - here.x) < kTolerance);
            CHECK(std::abs(there.y - here.y) < kTolerance);
            CHECK(plain.is_awake(id) == scaled.is_awake(id));
        }
    }
}

// The speculative distance is a tenth of the ball, far below a gap of its own size.
TEST_CASE("a 2 cm ball does not touch with a gap of 2 cm, and rests on the floor without one") {
    World world;
    add_floor(world);
    const BodyId ball = add_dynamic(world, {0.0, 0.03}, make_circle(0.01f));
    world.step();
    CHECK(world.contacts().empty());
    CHECK(world.events().contact_begins.empty());
    run(world, 120);
    CHECK(world.contacts().size() == 1);
    CHECK(near(world.state(ball).pose.position.y, 0.01, absolute(3.6e-5)));
}
