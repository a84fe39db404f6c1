// Restitution: heights, thresholds and head-on exchanges.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;

// A step ends at most half a step from a summit, where the height is lower by g (dt / 2)^2 / 2. The height of a contact
// is known to about as much: a bounce begins at the separation that the solver has left.
constexpr double kSummit = kGravity / (60.0 * 60.0) / 8.0;  // 0.35 mm
constexpr double kSeparation = kSummit;

struct Faller {
    Shape shape;
    double rest;  // of its centre over the floor, at rest
};

const Faller kFallers[] = {{make_circle(0.5f), 0.5},
                           {make_box({1.0f, 1.0f}), 0.5},
                           {make_box({2.0f, 0.5f}), 0.25},
                           {make_capsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.25f), 0.25}};

// How high a body rises over its resting height after each of its first bounces, which do not turn it.
std::vector<double> bounce_heights(const Faller& faller, float restitution, double drop, int substeps, int count) {
    World world({.substeps = substeps});
    add_floor(world, {.restitution = restitution});
    const BodyId body = add_dynamic(world, {0.0, faller.rest + drop}, faller.shape, {.restitution = restitution});
    std::vector<double> heights;
    bool rises = false;
    double highest = 0.0;
    for (int step = 0; step < 3600 && static_cast<int>(heights.size()) < count; ++step) {
        world.step();
        const BodyState state = world.state(body);
        highest = rises ? std::max(highest, state.pose.position.y - faller.rest) : 0.0;
        if (rises && state.velocity.y <= 0.0f) heights.push_back(highest);
        rises = state.velocity.y > 0.0f;
        CHECK(state.angular_velocity == 0.0f);
    }
    return heights;
}

}  // namespace

TEST_CASE("a shape that falls flat bounces to e^2 of the height, at any number of sub-steps") {
    for (const Faller& faller : kFallers)
        for (const int substeps : {1, 4, 8})
            for (const float e : {0.5f, 0.8f, 1.0f})
                for (const double drop : {1.0, 1.9, 2.7, 5.0}) {
                    CAPTURE(substeps);
                    CAPTURE(e);
                    CAPTURE(drop);
                    const std::vector<double> heights = bounce_heights(faller, e, drop, substeps, 1);
                    REQUIRE(heights.size() == 1);
                    CHECK(std::abs(heights[0] - e * e * drop) < kSummit + kSeparation);
                }
}

// Each of ten bounces may begin at another height.
TEST_CASE("ten bounces with restitution 1 neither gain nor lose height") {
    for (const Faller& faller : kFallers)
        for (const int substeps : {4, 8})
            for (const double drop : {1.0, 2.3, 4.1}) {
                CAPTURE(substeps);
                CAPTURE(drop);
                const std::vector<double> heights = bounce_heights(faller, 1.0f, drop, substeps, 10);
                REQUIRE(heights.size() == 10);
                CHECK(std::abs(heights[9] - drop) < kSummit + 10.0 * kSeparation);
            }
}

TEST_CASE("a slow approach does not bounce") {
    struct Drop {
        ImpactModel impacts;
        double height;  // m
    };
    // In order the threshold is twice what gravity adds in a step, 0.33 m/s: a fall of 5.6 mm. At the step's end it is
    // the tuning's 1 m/s: a fall of 5 cm.
    for (const auto& [impacts, height] : {Drop{ImpactModel::in_order, 0.005}, Drop{ImpactModel::at_step_end, 0.03}}) {
        World world({.impacts = impacts});
        add_floor(world, {.restitution = 1.0f});
        const BodyId ball = add_dynamic(world, {0.0, 0.5 + height}, make_circle(0.5f), {.restitution = 1.0f});
        run(world, 60);
        CHECK(std::abs(world.state(ball).velocity.y) < 1e-3);
        CHECK(std::abs(world.state(ball).pose.position.y - 0.5) < 1e-3);
    }
}

TEST_CASE("a ball moves with the same bits beside balls of another restitution") {
    const auto speeds_beside = [](float restitution, float rolling_resistance) {
        World world({.impacts = ImpactModel::at_step_end});
        add_floor(world);
        const SurfaceMaterial other{.restitution = restitution, .rolling_resistance = rolling_resistance};
        for (int i = 1; i < 8; ++i) add_dynamic(world, {3.0 * i, 1.7}, make_circle(0.5f), other);
        const BodyId ball = add_dynamic(world, {0.0, 1.7}, make_circle(0.5f));
        world.set_velocity(ball, {1.0f, 0.0f}, 0.0f);
        std::vector<float> speeds;
        for (int step = 0; step < 60; ++step) {
            world.step();
            speeds.push_back(world.state(ball).velocity.y);
            speeds.push_back(world.state(ball).angular_velocity);
        }
        return speeds;
    };
    const std::vector<float> alone = speeds_beside(0.0f, 0.0f);
    CHECK(*std::ranges::min_element(alone) < -4.0f);
    CHECK(speeds_beside(0.8f, 0.0f) == alone);
    CHECK(speeds_beside(0.0f, 0.1f) == alone);
}

TEST_CASE("equal balls that collide head-on exchange their velocities") {
    World world = weightless();
    const SurfaceMaterial bouncy{.restitution = 1.0f};
    const BodyId left = add_dynamic(world, {-2.0, 0.0}, make_circle(0.5f), bouncy);
    const BodyId right = add_dynamic(world, {2.0, 0.0}, make_circle(0.5f), bouncy);
    world.set_velocity(left, {3.0f, 0.0f}, 0.0f);
    world.set_velocity(right, {-2.0f, 0.0f}, 0.0f);
    run(world, 120);
    CHECK(near(world.state(left).velocity.x, -2.0, kFloat));
    CHECK(near(world.state(right).velocity.x, 3.0, kFloat));
}

TEST_CASE("balls that collide without restitution move on together, with the sum of their momenta") {
    World world = weightless();
    const BodyId heavy = add_dynamic(world, {-2.0, 0.0}, make_circle(0.5f), {.density = 3.0f});
    const BodyId light = add_dynamic(world, {2.0, 0.0}, make_circle(0.5f), {.density = 1.0f});
    world.set_velocity(heavy, {4.0f, 0.0f}, 0.0f);
    run(world, 120);
    CHECK(near(world.state(heavy).velocity.x, 3.0, kFloat));
    CHECK(near(world.state(light).velocity.x, 3.0, kFloat));
}
