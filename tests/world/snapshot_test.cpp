// Snapshots: a loaded world steps with the same bits, and incomplete snapshots throw.
#include <doctest/doctest.h>

#include <cstring>

#include "support/random_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Towers of boxes, each hinged to the one below at a corner: they fall, spread and come to rest.
World make_hinges(JointSolver joints) {
    World world({.joints = joints});
    add_floor(world);
    for (int tower = 0; tower < 3; ++tower) {
        BodyId below{};
        for (int i = 0; i < 6; ++i) {
            const double lean = 0.1 * (i % 2 == 0 ? 1.0 : -1.0) * (tower + 1);
            const BodyId box =
                add_dynamic(world, {2.5 * tower + 0.05 * i, 0.5 + 0.55 * i}, make_box({0.6f, 0.5f}, 0.02f), {}, lean);
            if (i % 2 == 1)
                world.create_joint(RevoluteJointDef{.body_a = below,
                                                    .body_b = box,
                                                    .anchor_a = {0.25f, 0.25f},
                                                    .anchor_b = {0.25f, -0.25f},
                                                    .limits = JointLimits{-0.4f, 0.8f},
                                                    .spring = JointSpring{2.0f, 0.4f}});
            below = box;
        }
    }
    return world;
}

World make_falling_hinges() { return make_hinges(JointSolver::iterative); }

std::vector<std::byte> saved_after(std::uint32_t seed, int steps) {
    RandomWorld random(seed);
    for (int step = 0; step < steps; ++step) {
        random.edit();
        random.world.step();
    }
    return random.world.save();
}

}  // namespace

TEST_CASE("falling hinges continue with the same bits from a snapshot of any step") {
    constexpr int kSteps = 240;
    World world = make_falling_hinges();
    std::vector<std::uint64_t> hashes;
    std::vector<std::vector<std::byte>> snapshots;
    for (int step = 0; step < kSteps; ++step) {
        snapshots.push_back(world.save());
        hashes.push_back(world.state_hash());
        world.step();
    }
    for (int start = 0; start < kSteps; ++start) {
        CAPTURE(start);
        World loaded = World::load(snapshots[static_cast<std::size_t>(start)]);
        REQUIRE(loaded.state_hash() == hashes[static_cast<std::size_t>(start)]);
        // The snapshot of the next step contains all results of the step; every twentieth run continues to the end.
        const int end = start % 20 == 0 ? kSteps - 1 : std::min(start + 1, kSteps - 1);
        while (loaded.step_count() < static_cast<std::uint64_t>(end)) {
            loaded.step();
            REQUIRE(loaded.state_hash() == hashes[loaded.step_count()]);
        }
        REQUIRE(loaded.save() == snapshots[static_cast<std::size_t>(end)]);
    }
    CHECK(world.counters().sleeping_islands > 0);  // the run has seen sleep
}

TEST_CASE("a random world and its loaded copy stay equal through the same edits and steps") {
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        RandomWorld first(seed);
        for (int step = 0; step < 40; ++step) {
            first.edit();
            first.world.step();
        }
        first.edit();  // a snapshot between an edit and its step
        RandomWorld second(first, World::load(first.world.save()));
        for (int step = 0; step < 40; ++step) {
            REQUIRE(first.world.save() == second.world.save());
            first.world.step();
            second.world.step();
            first.edit();
            second.edit();
        }
    }
}

TEST_CASE("an assigned world is the other one, whatever it was before") {
    for (const JointSolver joints : {JointSolver::iterative, JointSolver::direct})
        for (std::uint32_t seed = 1; seed <= 6; ++seed) {
            CAPTURE(seed);
            World reused = make_falling_hinges();
            run(reused, static_cast<int>(40 * seed));
            RandomWorld first(seed);
            for (int step = 0; step < 40; ++step) {
                first.edit();
                first.world.step();
            }
            reused.assign(first.world);
            reused.assign(reused);
            CHECK(reused.save() == first.world.save());
            for (int step = 0; step < 20; ++step) {
                first.world.step();
                reused.step();
                REQUIRE(reused.save() == first.world.save());
            }
            // The same with a world of joints in place of one of all kinds.
            World hinges = make_hinges(joints);
            run(hinges, static_cast<int>(10 * seed));
            reused.assign(hinges);
            run(hinges, 30);
            run(reused, 30);
            CHECK(reused.save() == hinges.save());
            reused.audit();
        }
}

TEST_CASE("a loaded world reports the same as the saved one") {
    World world = make_falling_hinges();
    run(world, 50);
    const World loaded = World::load(world.save());
    CHECK(loaded.step_count() == 50);
    CHECK(loaded.contacts().size() == world.contacts().size());
    CHECK(loaded.events().contact_begins.size() == world.events().contact_begins.size());
    CHECK(loaded.counters().contacts == world.counters().contacts);
    CHECK(loaded.def().gravity == world.def().gravity);
    for (const JointId id : world.joints()) {
        CHECK(loaded.joint_position(id) == world.joint_position(id));
        CHECK(loaded.reaction(id).force == world.reaction(id).force);
    }
    loaded.audit();
}

TEST_CASE("an incomplete, damaged or foreign snapshot throws") {
    const std::vector<std::byte> whole = saved_after(3, 10);
    CHECK_NOTHROW(World::load(whole));
    for (std::size_t size = 0; size < whole.size(); size += 1 + size / 7) {
        CAPTURE(size);
        CHECK_THROWS_AS(World::load({whole.data(), size}), SnapshotError);
    }
    for (std::size_t at = 0; at < whole.size(); at += 1 + at / 7) {
        CAPTURE(at);
        std::vector<std::byte> damaged = whole;
        damaged[at] ^= std::byte{0x10};
        CHECK_THROWS_AS(World::load(damaged), SnapshotError);
    }
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{});
    CHECK_THROWS_AS(World::load(longer), SnapshotError);
}

TEST_CASE("a snapshot of another version is refused, and the error names both versions") {
    std::vector<std::byte> snapshot = saved_after(3, 10);
    snapshot[8] = std::byte{99};
    CHECK_THROWS_WITH(World::load(snapshot), "snapshot: it has version 99, this build reads version 17");
    snapshot[8] = std::byte{16};
    CHECK_THROWS_WITH(World::load(snapshot), "snapshot: it has version 16, this build reads version 17");
}

// After a change of the contents of snapshots, raise kVersion in snapshot.cpp and update the size here.
TEST_CASE("the size of a snapshot changes only with the version") {
    World world = make_falling_hinges();
    CHECK(world.save().size() == 12384);
    for (int step = 0; step < 200 && world.counters().contacts < 6; ++step) world.step();
    REQUIRE(world.counters().contacts == 6);
    CHECK(world.save().size() == 14874);
}
