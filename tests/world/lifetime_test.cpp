// Ids, creation and destruction at any time between steps.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("ids of destroyed objects are stale, also when their index is used again") {
    World world;
    const BodyId first = add_dynamic(world, {}, make_circle(0.5f));
    const ShapeId shape = world.shapes(first)[0];
    world.destroy_body(first);
    const BodyId second = world.create_body({});
    CHECK(second.index == first.index);
    CHECK_FALSE(world.is_valid(first));
    CHECK_FALSE(world.is_valid(shape));
    CHECK(world.is_valid(second));
    CHECK_THROWS_WITH_AS(world.state(first), "body id is stale: the body was destroyed (index 0, generation 0)",
                         std::invalid_argument);
    CHECK_THROWS_AS(world.destroy_body(first), std::invalid_argument);
    CHECK_THROWS_WITH_AS(world.shape(shape), "shape id is stale: the shape was destroyed (index 0, generation 0)",
                         std::invalid_argument);
    CHECK_THROWS_AS(world.state(BodyId{}), std::invalid_argument);
}

TEST_CASE("live ids are listed in order") {
    World world;
    std::vector<BodyId> ids;
    for (int i = 0; i < 5; ++i) ids.push_back(world.create_body({}));
    world.destroy_body(ids[1]);
    world.destroy_body(ids[3]);
    const BodyId reused = world.create_body({});
    CHECK(std::vector<BodyId>(world.bodies().begin(), world.bodies().end()) ==
          std::vector<BodyId>{ids[0], ids[2], reused, ids[4]});
}

TEST_CASE("bodies fall when their floor is destroyed, and its contacts are not reported") {
    World world;
    const BodyId floor = add_floor(world);
    const BodyId box = add_dynamic(world, {0.0, 0.5}, make_box({1.0f, 1.0f}));
    run(world, 10);
    CHECK(world.contacts().size() == 2);
    world.destroy_body(floor);
    CHECK(world.contacts().empty());
    world.audit();
    run(world, 60);
    CHECK(world.state(box).pose.position.y < -3.0);
}

TEST_CASE("a shape with the index of a destroyed one inherits no contact") {
    World world = weightless();
    const BodyId a = add_dynamic(world, {0.0, 0.0}, make_box({1.0f, 1.0f}));
    const BodyId b = add_dynamic(world, {0.9, 0.0}, make_box({1.0f, 1.0f}));
    world.step();
    world.destroy_body(b);
    const BodyId c = add_dynamic(world, {50.0, 0.0}, make_box({1.0f, 1.0f}));
    CHECK(world.contacts().empty());
    run(world, 2);
    CHECK(world.contacts().empty());
    CHECK(world.is_valid(a));
    CHECK(world.state(c).velocity == Vec2{});
    world.audit();
}

TEST_CASE("destroying a body destroys its joints") {
    World world;
    const BodyId a = add_static(world, {}, make_circle(0.1f));
    const BodyId b = add_dynamic(world, {0.0, -1.0}, make_circle(0.1f));
    const JointId joint = world.create_joint(DistanceJointDef{.body_a = a, .body_b = b});
    world.destroy_body(a);
    CHECK_FALSE(world.is_valid(joint));
    CHECK(world.joints().empty());
    run(world, 2);
    world.audit();
}

// Joints tear here by metres. Rows that act on torn joints with long arms diverge in half of such worlds.
TEST_CASE("every invariant holds through random creation and destruction") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        World world;
        add_floor(world);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> x(-6.0, 6.0), y(0.5, 8.0);
        std::vector<BodyId> bodies;
        std::vector<JointId> joints;
        int destroyed = 0, touching = 0;
        const auto take = [&](auto& list) {
            const std::size_t at = random() % list.size();
            const auto id = list[at];
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
            return id;
        };
        for (int round = 0; round < 400; ++round) {
            const std::size_t dice = random() % 10;
            if (dice < 5 || bodies.size() < 4) {
                const auto type = dice == 0 ? BodyType::kinematic_body : BodyType::dynamic_body;
                bodies.push_back(add_body(world, type, {x(random), y(random)}, make_box({0.8f, 0.6f})));
                if (dice == 1) world.add_shape(bodies.back(), {make_circle(0.3f, {0.6f, 0.0f}), {}});
            } else if (dice < 7) {
                world.destroy_body(take(bodies));
                ++destroyed;
            } else if (dice < 9) {
                const BodyId a = bodies[random() % bodies.size()], b = bodies[random() % bodies.size()];
                if (a != b) joints.push_back(world.create_joint(RevoluteJointDef{.body_a = a, .body_b = b}));
            } else if (!joints.empty()) {
                const JointId joint = take(joints);
                if (world.is_valid(joint)) world.destroy_joint(joint);
            }
            world.audit();
            world.step();
            world.audit();
            touching += world.counters().contacts;
        }
        CHECK(destroyed > 40);
        CHECK(touching > 1000);
    }
}
