// Dominoes, overlap that is pushed out, and a heavy body on a light one. How far piles sink is in sag_test.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

double height(const World& world, BodyId body) { return world.state(body).pose.position.y; }

}  // namespace

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

TEST_CASE("overlapping bodies are pushed apart at 2.5 m/s at most") {
    World world = weightless();
    const BodyId left = add_dynamic(world, {-0.2, 0.0}, make_box({1.0f, 1.0f}));
    const BodyId right = add_dynamic(world, {0.2, 0.0}, make_box({1.0f, 1.0f}));
    double before = 0.4, fastest = 0.0;
    for (int step = 0; step < 30; ++step) {
        world.step();
        const double now = world.state(right).pose.position.x - world.state(left).pose.position.x;
        CHECK(now - before <= 2.5 / 60.0 + 1e-6);
        fastest = std::max(fastest, 60.0 * (now - before));
        before = now;
    }
    // The spring alone would push by 15.6 / s of 0.6 m; a soft contact reaches its mass scale, 0.95, of its bias
    // velocity.
    CHECK(fastest > 0.95 * 2.5);
    CHECK(before > 0.9);
    CHECK(world.state(right).velocity.x - world.state(left).velocity.x < 0.1f);  // no speed remains
}

TEST_CASE("a heavy box rests on a light one, a thousand to one") {
    World world;
    add_floor(world);
    const BodyId light = add_dynamic(world, {0.0, 0.5}, make_box({1.0f, 1.0f}), {.density = 1.0f});
    const BodyId heavy = add_dynamic(world, {0.0, 1.5}, make_box({1.0f, 1.0f}), {.density = 1000.0f});
    run(world, 600);
    // The heavy box overlaps the light one by F / (m_eff w^2) with the mass of the light one. It must neither push it
    // out sideways nor pass through it.
    CHECK(height(world, heavy) > height(world, light) + 0.4);
    CHECK(std::abs(world.state(light).pose.position.x) < 0.05);
}
