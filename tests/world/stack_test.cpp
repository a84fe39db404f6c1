// Piles: how far they sink, that they stay, and that dominoes fall in order.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;
constexpr double kOmega = 2.0 * kPi * 30.0;  // contact softness, rad/s

// How far the top of n equal boxes sinks. A contact that carries k boxes above it gives way by F / (m_eff w^2) with
// F = k m g and the effective mass of two points on two boxes, m / 2.5; on the ground m / 1.25 at twice the frequency.
double stack_sag(int n) {
    double sum = 1.25 * n * kGravity / (4.0 * kOmega * kOmega);
    for (int k = 1; k < n; ++k) sum += 2.5 * k * kGravity / (kOmega * kOmega);
    return sum;
}

std::vector<BodyId> add_stack(World& world, int n, float side) {
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < n; ++i) boxes.push_back(add_dynamic(world, {0.0, (i + 0.5) * side}, make_box({side, side})));
    return boxes;
}

double height(const World& world, BodyId body) {
    return world.state(body).pose.position.y;
}

}  // namespace

TEST_CASE("a stack of 20 boxes sinks by the closed form") {
    CHECK(stack_sag(20) == doctest::Approx(0.1354).epsilon(0.001));
    World world;
    const BodyId top = add_stack(world, 20, 1.0f).back();
    run(world, 600);
    CHECK(19.5 - height(world, top) == doctest::Approx(stack_sag(20)).epsilon(0.05));
}

TEST_CASE("a stack neither creeps down nor leans") {
    World world;
    const std::vector<BodyId> boxes = add_stack(world, 20, 1.0f);
    run(world, 300);
    const double settled = height(world, boxes.back());
    run(world, 3300);
    CHECK(std::abs(height(world, boxes.back()) - settled) < 0.001);
    for (const BodyId box : boxes) {
        CHECK(std::abs(world.state(box).pose.position.x) < 0.01);
        CHECK(length(world.state(box).velocity) < 0.001);
    }
}

TEST_CASE("a pyramid comes to rest and stands") {
    World world;
    add_pyramid(world, 20);
    run(world, 600);
    double top = 0.0;
    for (const BodyId id : world.bodies()) {
        CHECK(length(world.state(id).velocity) < 0.01);
        top = std::max(top, height(world, id));
    }
    // Its closed form for 20 rows is a sag of 30 mm.
    CHECK(19.5 - top == doctest::Approx(0.030).epsilon(0.1));
    for (const ContactPoint& point : world.contacts()) CHECK(point.separation > -0.02f);
}

TEST_CASE("dominoes fall in order, all of them") {
    World world;
    add_floor(world);
    std::vector<BodyId> dominoes;
    for (int i = 0; i < 10; ++i) dominoes.push_back(add_dynamic(world, {0.6 * i, 0.5}, make_box({0.1f, 1.0f})));
    world.set_velocity(dominoes.front(), {0.0f, 0.0f}, -3.0f);
    std::vector<int> fallen_at(dominoes.size(), -1);
    for (int step = 0; step < 600; ++step) {
        world.step();
        for (std::size_t i = 0; i < dominoes.size(); ++i)
            if (fallen_at[i] < 0 && angle(world.state(dominoes[i]).pose.rotation) < -0.5) fallen_at[i] = step;
    }
    CHECK(fallen_at.front() >= 0);
    CHECK(std::is_sorted(fallen_at.begin(), fallen_at.end()));
    CHECK(std::adjacent_find(fallen_at.begin(), fallen_at.end()) == fallen_at.end());
}

TEST_CASE("overlap is pushed out at 3 m/s at the fastest") {
    World world = weightless();
    const BodyId left = add_dynamic(world, {-0.2, 0.0}, make_box({1.0f, 1.0f}));
    const BodyId right = add_dynamic(world, {0.2, 0.0}, make_box({1.0f, 1.0f}));
    double before = 0.4;
    for (int step = 0; step < 30; ++step) {
        world.step();
        const double now = world.state(right).pose.position.x - world.state(left).pose.position.x;
        CHECK(now - before <= 3.0 / 60.0 + 1e-6);
        before = now;
    }
    CHECK(before > 0.9);
    CHECK(world.state(right).velocity.x - world.state(left).velocity.x < 0.1f);  // no energy is left behind
}

TEST_CASE("a heavy box rests on a light one, a thousand to one") {
    World world;
    add_floor(world);
    const BodyId light = add_dynamic(world, {0.0, 0.5}, make_box({1.0f, 1.0f}), {.density = 1.0f});
    const BodyId heavy = add_dynamic(world, {0.0, 1.5}, make_box({1.0f, 1.0f}), {.density = 1000.0f});
    run(world, 600);
    // The light one is squeezed, by F / (m_eff w^2) with its own mass: it must neither pop out nor be passed through.
    CHECK(height(world, heavy) > height(world, light) + 0.4);
    CHECK(std::abs(world.state(light).pose.position.x) < 0.05);
}
