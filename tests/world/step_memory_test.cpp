// Steps in lent memory: worlds that share it make the steps that they make in memory of their own, bit for bit.
#include <doctest/doctest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "support/random_world.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Piles, fast bodies, a sensor that one of them crosses and a pendulum, under each kind of solver: what a step leaves
// in its memory differs as much as it can.
World make_world(int kind) {
    WorldDef def;
    def.joints = kind % 2 == 0 ? JointSolver::iterative : JointSolver::direct;
    def.impacts = kind / 2 % 2 == 0 ? ImpactModel::in_order : ImpactModel::at_step_end;
    World world(def);
    add_pyramid(world, 3 + kind);
    const BodyId zone = add_static(world, {-20.0, 5.0}, make_box({0.1f, 0.1f}));
    world.add_shape(zone, {.shape = make_box({0.01f, 2.0f}), .sensor = true});
    for (int i = 0; i <= kind; ++i) {
        const BodyId bullet = add_dynamic(world, {-30.0, 4.0 + 0.5 * i}, make_circle(0.1f));
        world.set_velocity(bullet, {150.0f + 10.0f * static_cast<float>(kind), 0.0f}, 1.0f);
    }
    const BodyId pivot = add_static(world, {30.0, 20.0}, make_circle(0.1f));
    BodyId above = pivot;
    for (int i = 0; i <= kind; ++i) {
        const BodyId link = add_dynamic(world, {32.0 + 2.0 * i, 20.0}, make_box({0.9f, 0.1f}));
        world.create_joint(RevoluteJointDef{.body_a = above,
                                            .body_b = link,
                                            .anchor_a = {above == pivot ? 0.0f : 1.0f, 0.0f},
                                            .anchor_b = {-1.0f, 0.0f}});
        above = link;
    }
    return world;
}

}  // namespace

TEST_CASE("worlds that share the memory of their steps have the same states, events and counters") {
    std::vector<World> own, sharing;
    for (int kind = 0; kind < 4; ++kind) {
        own.push_back(make_world(kind));
        sharing.push_back(make_world(kind));
    }
    StepMemory memory;
    for (int step = 0; step < 150; ++step) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            own[i].step();
            sharing[i].step(memory);
            REQUIRE(sharing[i].save() == own[i].save());
            REQUIRE(sharing[i].counters().colors == own[i].counters().colors);
            REQUIRE(sharing[i].counters().collided == own[i].counters().collided);
        }
    }
    for (World& world : sharing) world.audit();
}

TEST_CASE("a world may step in its own memory and in lent memory in turns") {
    World own = make_world(1), both = make_world(1);
    StepMemory first, second;
    for (int step = 0; step < 60; ++step) {
        own.step();
        if (step % 3 == 0)
            both.step();
        else
            both.step(step % 3 == 1 ? first : second);
        if (step == 30) first = std::move(second);
        REQUIRE(both.save() == own.save());
        both.audit();
    }
}

TEST_CASE("a world that steps in lent memory keeps less than one that has its own") {
    World own = make_world(0), lent = make_world(0);
    StepMemory memory;
    own.step();
    lent.step(memory);
    CHECK(lent.memory().total() < own.memory().total());
    CHECK(lent.memory().solver == 0);
    CHECK(lent.memory().contacts == own.memory().contacts);
}

TEST_CASE("bodies of a world that has no memory of its own can be put to sleep") {
    World world = make_world(0);
    StepMemory memory;
    world.step(memory);
    for (const BodyId body : world.bodies()) world.set_awake(body, false);
    world.step(memory);
    CHECK(world.counters().awake_bodies == 0);
}

TEST_CASE("random worlds that are edited share the memory of their steps") {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        RandomWorld own[] = {RandomWorld(seed), RandomWorld(seed + 100)},
                    sharing[] = {RandomWorld(seed), RandomWorld(seed + 100)};
        StepMemory memory;
        for (int step = 0; step < 40; ++step) {
            for (const int i : {0, 1}) {
                own[i].edit();
                sharing[i].edit();
                own[i].world.step();
                sharing[i].world.step(memory);
                REQUIRE(sharing[i].world.save() == own[i].world.save());
            }
        }
    }
}

TEST_CASE("memory serves other worlds after a world that diverges in it") {
    World lost(WorldDef{.steps_per_second = 0.1f});  // 10 s at 3e38 m/s: more than a float can represent
    add_pyramid(lost, 5);
    lost.create_body({.type = BodyType::kinematic_body, .velocity = {3e38f, 0.0f}});
    StepMemory memory;
    CHECK_THROWS_AS(lost.step(memory), SimulationDiverged);
    World other = make_world(0), expected = make_world(0);
    other.step(memory);
    expected.step();
    CHECK(other.save() == expected.save());
}
