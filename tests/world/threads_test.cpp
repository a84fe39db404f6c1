// A world makes the same steps with any number of threads, bit for bit.
//
// TUMBLE_THREADED_WORLDS=n compares n random worlds instead of a few.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/environment.hpp"
#include "support/random_world.hpp"
#include "support/thread_tasks.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kThreads[] = {2, 3, 8};

// Steps a world on one thread and the same world on several, and compares their states after each step, and all that a
// snapshot contains after each tenth.
template <class Make>
void check_threads(Make&& make, int steps) {
    World serial = make();
    std::vector<World> others;
    for (const int threads : kThreads) {
        others.push_back(make());
        others.back().set_threads(eager_threads(threads));
    }
    for (int step = 1; step <= steps; ++step) {
        serial.step();
        for (World& world : others) {
            world.step();
            REQUIRE(world.state_hash() == serial.state_hash());
            if (step % 10 == 0) REQUIRE(world.save() == serial.save());
        }
    }
    for (World& world : others) world.audit();
}

// Shapes of all kinds with several surfaces, a belt and a sensor.
World make_heap(const WorldDef& def) {
    World world(def);
    add_floor(world, {.tangent_speed = 0.5f});
    const BodyId zone = add_static(world, {0.0, 2.0}, make_box({0.1f, 0.1f}));
    world.add_shape(zone, {.shape = make_box({4.0f, 1.0f}), .sensor = true});
    std::mt19937 random(7);
    for (int i = 0; i < 150; ++i) {
        const DVec2 position{-4.0 + 0.8 * (i % 11), 0.5 + 0.8 * (i / 11)};
        const auto size = 0.2f + 0.001f * static_cast<float>(random() % 200);
        const SurfaceMaterial material{.restitution = 0.3f * static_cast<float>(i % 3), .rolling_resistance = 0.02f};
        switch (i % 3) {
            case 0: add_dynamic(world, position, make_circle(size), material, i); break;
            case 1: add_dynamic(world, position, make_box({size, 0.7f * size}), material, i); break;
            default: add_dynamic(world, position, make_capsule({-size, 0.0f}, {size, 0.0f}, 0.1f), material, i);
        }
    }
    return world;
}

// Towers that fall over, built one after the other: 2100 bodies in two regions, which threads solve side by side.
World make_towers(ImpactModel impacts) {
    World world({.impacts = impacts});
    add_static(world, {0.0, -0.5}, make_box({600.0f, 0.5f}));
    for (int tower = 0; tower < 210; ++tower)
        for (int level = 0; level < 10; ++level) {
            const DVec2 position{3.0 * tower + 0.06 * level * level, 0.5 + 1.02 * level};
            add_dynamic(world, position, make_box({0.5f, 0.5f}), {.restitution = 0.2f * static_cast<float>(tower % 3)});
        }
    return world;
}

// A net of hinges that hangs from two bodies, with weights.
World make_net(const WorldDef& def, int rows = 8) {
    constexpr int kColumns = 12;
    World world(def);
    std::vector<BodyId> knots;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const bool is_held = row == 0 && (column == 2 || column == 9);
            knots.push_back(add_body(world, is_held ? BodyType::static_body : BodyType::dynamic_body,
                                     {static_cast<double>(column), -static_cast<double>(row)}, make_circle(0.3f)));
        }
    const auto join = [&](int from, int to, Vec2 half) {
        world.create_joint(RevoluteJointDef{.body_a = knots[static_cast<std::size_t>(from)],
                                            .body_b = knots[static_cast<std::size_t>(to)],
                                            .anchor_a = half,
                                            .anchor_b = -half});
    };
    for (int i = 0; i < kColumns * rows; ++i) {
        if (i % kColumns + 1 < kColumns) join(i, i + 1, {0.5f, 0.0f});
        if (i + kColumns < kColumns * rows) join(i, i + kColumns, {0.0f, -0.5f});
        if (i % 5 == 0 && i >= kColumns)
            world.create_joint(DistanceJointDef{.body_a = knots[0],
                                                .body_b = knots[static_cast<std::size_t>(i)],
                                                .length = 9.0f,
                                                .spring = JointSpring{2.0f, 0.5f}});
    }
    return world;
}

// Marbles that run down a chain of one-sided segments, and fall through it from below.
World make_chain_run() {
    World world;
    std::vector<Vec2> points;
    for (int i = 30; i >= -30; --i) points.push_back({static_cast<float>(i), 0.02f * static_cast<float>(i * i)});
    const BodyId ground = world.create_body({.type = BodyType::static_body});
    const std::vector<Shape> segments = make_chain(points, false);
    const std::vector<ChainLink> links = make_chain_links(points, false, true);
    for (std::size_t i = 0; i < segments.size(); ++i) world.add_shape(ground, {.shape = segments[i], .link = links[i]});
    for (int i = 0; i < 60; ++i) {
        const BodyId marble = add_dynamic(world, {-10.0 + i % 20, 4.0 - 3.0 * (i / 20)}, make_circle(0.3f));
        world.set_velocity(marble, {0.0f, i < 40 ? -3.0f : 12.0f}, 0.0f);
    }
    return world;
}

}  // namespace

TEST_CASE("a pyramid makes the same steps on any number of threads") {
    check_threads(
        [] {
            World world;
            add_pyramid(world, 20);
            return world;
        },
        60);
}

TEST_CASE("a heap makes the same steps on any number of threads") {
    check_threads([] { return make_heap({}); }, 150);
}

TEST_CASE("impacts in order are the same on any number of threads") {
    check_threads([] { return make_heap({.impacts = ImpactModel::in_order}); }, 60);
}

TEST_CASE("towers in several regions make the same steps on any number of threads") {
    check_threads([] { return make_towers(ImpactModel::at_step_end); }, 20);
    check_threads([] { return make_towers(ImpactModel::in_order); }, 10);
}

TEST_CASE("a net of joints makes the same steps on any number of threads") {
    check_threads([] { return make_net({}); }, 60);
    check_threads([] { return make_net({.joints = JointSolver::direct}); }, 30);
    check_threads([] { return make_net({}, 100); }, 40);  // 2288 hinges: several blocks
}

TEST_CASE("one-sided chains are the same on any number of threads") { check_threads(make_chain_run, 150); }

TEST_CASE("random worlds that are edited make the same steps on any number of threads") {
    const int worlds = from_environment("TUMBLE_THREADED_WORLDS", 12);
    REQUIRE(worlds > 0);
    for (int i = 1; i <= worlds; ++i) {
        const auto seed = static_cast<std::uint32_t>(i);
        CAPTURE(seed);
        RandomWorld serial(seed), parallel(seed);
        parallel.world.set_threads(eager_threads(kThreads[seed % 3]));
        for (int step = 0; step < 60; ++step) {
            serial.edit();
            parallel.edit();
            serial.world.step();
            parallel.world.step();
            REQUIRE(parallel.world.state_hash() == serial.world.state_hash());
        }
        CHECK(parallel.world.save() == serial.world.save());
    }
}

TEST_CASE("threads of oneTBB make the same steps, and may be changed at any time") {
    World serial = make_heap({}), parallel = make_heap({.threads = {.count = 0, .least_work = 0}});
    for (int step = 0; step < 60; ++step) {
        if (step % 8 == 7) parallel.set_threads({.count = step % 5, .least_work = step});
        serial.step();
        parallel.step();
        REQUIRE(parallel.state_hash() == serial.state_hash());
    }
}

TEST_CASE("a world of a snapshot has one thread") {
    World world = make_heap({.threads = eager_threads(3)});
    const World loaded = World::load(world.save());
    CHECK(world.def().threads.count == 3);
    CHECK(loaded.def().threads.count == 1);
}

TEST_CASE("step_all makes one step of each world") {
    for (const int threads : {1, 2, 3}) {
        std::vector<World> worlds, expected;
        std::vector<World*> all;
        for (int i = 0; i < 20; ++i) {
            for (std::vector<World>* const list : {&worlds, &expected}) {
                list->emplace_back();
                add_pyramid(list->back(), 1 + i % 5);
            }
        }
        for (World& world : worlds) all.push_back(&world);
        for (int step = 0; step < 20; ++step) {
            step_all(all, eager_threads(threads));
            for (World& world : expected) world.step();
        }
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            CHECK(worlds[i].step_count() == 20);
            CHECK(worlds[i].state_hash() == expected[i].state_hash());
        }
    }
}

TEST_CASE("step_all throws the exception of the first world, after all have made their step") {
    std::vector<World> worlds;
    std::vector<World*> all;
    for (int i = 0; i < 6; ++i) {
        World& world = worlds.emplace_back(WorldDef{.steps_per_second = 0.1f});
        for (int bodies = 0; bodies <= i; ++bodies) add_dynamic(world, {2.0 * bodies, 5.0}, make_circle(0.5f));
    }
    for (World& world : worlds) all.push_back(&world);
    for (const std::size_t broken : {2u, 4u})  // 10 s at 3e38 m/s: more than a float can represent
        worlds[broken].create_body({.type = BodyType::kinematic_body, .velocity = {3e38f, 0.0f}});
    try {
        step_all(all, eager_threads(2));
        FAIL("an infinite position went unnoticed");
    } catch (const SimulationDiverged& error) {
        CHECK(error.body == worlds[2].bodies().back());
    }
    for (const World& world : worlds) CHECK(world.step_count() == 1);
}

TEST_CASE("negative numbers of threads are refused") {
    World world;
    CHECK_THROWS_WITH_AS(world.set_threads({.count = -1}), "threads count must not be negative, got -1",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(World(WorldDef{.threads = {.least_work = -2}}),
                         "threads least_work must not be negative, got -2", std::invalid_argument);
}
