// The order of the solver bodies: bodies that touch are near each other in memory, and no result depends on it.
#include "dynamics/stages/body_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "dynamics/step.hpp"
#include "support/thread_tasks.hpp"
#include "support/world_parts.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

enum class Creation { by_row, shuffled };

// Boxes in rows of 32, whose sides touch, each with a velocity of its own.
World make_wall(std::size_t boxes, Creation creation, const Threads& threads = {}) {
    WorldDef def;
    def.gravity = {0.0f, 0.0f};
    World world(def);
    world.set_threads(threads);
    std::vector<std::size_t> places(boxes);
    for (std::size_t i = 0; i < boxes; ++i) places[i] = i;
    if (creation == Creation::shuffled) std::shuffle(places.begin(), places.end(), std::mt19937(1));
    for (const std::size_t place : places) {
        const DVec2 position{static_cast<double>(place % 32), static_cast<double>(place / 32)};
        const BodyId id = add_dynamic(world, position, make_box({1.0f, 1.0f}));
        world.set_velocity(id, {0.01f * static_cast<float>(place % 7), -0.01f * static_cast<float>(place % 5)}, 0.0f);
    }
    return world;
}

// The same after a step, which makes the contacts.
WorldParts make_wall_parts(std::size_t boxes, Creation creation) {
    World world = make_wall(boxes, creation);
    world.step();
    return WorldParts(world.save());
}

std::vector<std::uint32_t> order(const Simulation& simulation) {
    std::vector<std::uint32_t> bodies;
    for (const MovingBody& moving : simulation.bodies.moving) bodies.push_back(moving.body);
    return bodies;
}

// The part of the contacts whose solver bodies are less than 64 apart.
double near_part(const Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    double near = 0.0;
    for (const Contact& contact : simulation.contacts.all()) {
        const std::int64_t a = bodies.frames[contact.body_a].solver_body;
        const std::int64_t b = bodies.frames[contact.body_b].solver_body;
        near += std::abs(a - b) < 64 ? 1.0 : 0.0;
    }
    return near / static_cast<double>(simulation.contacts.all().size());
}

bool are_equal(const Simulation& x, const Simulation& y) {
    for (std::uint32_t body = 0; body < x.bodies.frames.size(); ++body) {
        const BodyFrame &a = x.bodies.frames[body], &b = y.bodies.frames[body];
        const SolverBody& moved_a = x.bodies.solver_bodies[a.solver_body];
        const SolverBody& moved_b = y.bodies.solver_bodies[b.solver_body];
        if (a.pose != b.pose || moved_a.velocity != moved_b.velocity ||
            moved_a.angular_velocity != moved_b.angular_velocity)
            return false;
    }
    return true;
}

}  // namespace

TEST_CASE("bodies that were created in random order come near those that they touch") {
    WorldParts parts = make_wall_parts(1024, Creation::shuffled);
    Simulation& simulation = parts.simulation;
    REQUIRE(simulation.contacts.all().size() > 1800);
    CHECK(near_part(simulation) < 0.2);
    order_bodies(simulation);
    CHECK(near_part(simulation) > 0.8);
    for (std::uint32_t i = 1; i < simulation.bodies.moving.size(); ++i)
        REQUIRE(simulation.bodies.frames[simulation.bodies.moving[i].body].solver_body == i);
    const std::vector<std::uint32_t> ordered = order(simulation);
    order_bodies(simulation);
    CHECK(order(simulation) == ordered);
}

TEST_CASE("bodies that were created row by row, and few bodies, keep their order") {
    const auto keeps_order = [](WorldParts parts) {
        const std::vector<std::uint32_t> before = order(parts.simulation);
        order_bodies(parts.simulation);
        return order(parts.simulation) == before;
    };
    CHECK(keeps_order(make_wall_parts(1024, Creation::by_row)));
    CHECK(keeps_order(make_wall_parts(500, Creation::shuffled)));
}

TEST_CASE("a world whose bodies are put in order moves as one whose bodies are not") {
    WorldParts parts = make_wall_parts(600, Creation::shuffled), same_parts = make_wall_parts(600, Creation::shuffled);
    Simulation &kept = parts.simulation, &ordered = same_parts.simulation;
    kept.settings.gravity = ordered.settings.gravity = {1.0f, -3.0f};
    order_bodies(ordered);
    REQUIRE(order(ordered) != order(kept));
    for (int i = 0; i < 30; ++i) {
        if (i % 10 == 5) {  // in the other order, among what earlier steps left in the scratch memory
            std::vector<std::uint32_t> reversed(ordered.bodies.moving.size());
            for (std::uint32_t k = 1; k < reversed.size(); ++k)
                reversed[k] = static_cast<std::uint32_t>(reversed.size()) - k;
            ordered.bodies.reorder(reversed);
        }
        REQUIRE(step(kept, 1));  // no step that sorts
        REQUIRE(step(ordered, 1));
        REQUIRE(are_equal(kept, ordered));
    }
}

TEST_CASE("a world puts scattered bodies in order, on any number of threads and after loading alike") {
    const auto run = [](int threads, int loaded_at) {
        World world = make_wall(600, Creation::shuffled, threads == 1 ? Threads{} : eager_threads(threads));
        world.set_gravity({1.0f, -3.0f});
        for (int i = 0; i < 40; ++i) {
            if (i == loaded_at) world = World::load(world.save());
            world.step();
        }
        return world.save();
    };
    const std::vector<std::byte> alone = run(1, -1);
    CHECK(near_part(WorldParts(alone).simulation) > 0.7);
    CHECK(run(2, -1) == alone);
    CHECK(run(3, -1) == alone);
    for (const int loaded_at : {5, 16, 20}) CHECK(run(1, loaded_at) == alone);
}
