// Sleep: which bodies fall asleep and when, and that sleep costs nothing and changes nothing.
#include <doctest/doctest.h>

#include <set>
#include <stdexcept>
#include <vector>

#include "support/near.hpp"
#include "support/sleepers.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Steps until the body sleeps; the number of steps, or -1 if it does not within a minute.
int steps_until_asleep(World& world, BodyId body) {
    for (int step = 0; step < 3600; ++step) {
        if (!world.is_awake(body)) return step;
        world.step();
    }
    return -1;
}

}  // namespace

TEST_CASE("every step counts the pairs of awake bodies, also the one in which all fall asleep") {
    World world;
    const BodyId floor = world.create_body({.type = BodyType::static_body});
    world.add_shape(floor, {.shape = make_box({20.0f, 1.0f}, 0.0f, {0.0f, -0.5f})});
    for (int i = 0; i < 5; ++i)
        world.add_shape(world.create_body({.pose = {{2.0 * i - 4.0, 0.5}, {}}}), {.shape = make_box({1.0f, 1.0f})});
    bool has_slept = false;
    for (int step = 0; step < 120 && !has_slept; ++step) {
        world.step();
        const StepCounters& counters = world.counters();
        CHECK(counters.collided <= counters.pairs);
        CHECK(counters.pairs == 5);
        has_slept = counters.awake_bodies == 0;
    }
    CHECK(has_slept);
    world.step();
    CHECK(world.counters().pairs == 0);
}

// Damping that slows a body by a part of 5e-5 in half a second.
constexpr float kFaintDamping = 1e-4f;

TEST_CASE("a body without forces sleeps after half a second of rest, to the step") {
    World world = weightless();
    const BodyId body = add_dynamic(world, {}, kBox);
    CHECK(steps_until_asleep(world, body) == 30);
    world.set_velocity(body, {4e-5f, 0.0f}, 0.0f);  // what rounding may leave: below 1e-3 of 0.05 m/s
    CHECK(steps_until_asleep(world, body) == 30);
    world.set_damping(body, kFaintDamping, kFaintDamping);
    world.set_velocity(body, {0.049f, 0.0f}, 0.0f);
    CHECK(world.is_awake(body));
    CHECK(steps_until_asleep(world, body) == 30);
    CHECK(world.state(body).velocity == Vec2{});
    world.set_velocity(body, {0.051f, 0.0f}, 0.0f);
    CHECK(steps_until_asleep(world, body) == -1);
}

TEST_CASE("beside an island that cannot fall asleep, another one does at most three steps late, also after loading") {
    const auto steps_to_sleep = [](bool has_restless, int created_at, bool reloads) {
        World world;
        add_floor(world);
        if (has_restless) {
            add_dynamic(world, {-5.0, 0.5}, make_box({1.0f, 1.0f}));
            const BodyId restless = world.create_body({.pose = {{-5.0, 1.5}, {}}, .allow_sleep = false});
            world.add_shape(restless, {.shape = make_box({1.0f, 1.0f})});
        }
        run(world, created_at);
        const BodyId box = add_dynamic(world, {5.0, 0.5}, make_box({1.0f, 1.0f}));
        int steps = 0;
        for (; world.is_awake(box) && steps < 60; ++steps) {
            if (reloads) world = World::load(world.save());
            world.step();
        }
        return steps;
    };
    const int alone = steps_to_sleep(false, 60, false);
    std::set<int> delays;
    for (int created_at = 60; created_at < 68; ++created_at) {
        const int steps = steps_to_sleep(true, created_at, false);
        CHECK(steps_to_sleep(true, created_at, true) == steps);
        delays.insert(steps - alone);
    }
    CHECK(delays == std::set{0, 1, 2, 3});
}

TEST_CASE("a body falls asleep only if its farthest point is slow") {
    // Corners of a unit box at 0.707 m from its centre: 0.05 / 0.707 = 0.0707 rad/s is the limit.
    for (const bool slow : {true, false}) {
        World world = weightless();
        const BodyId body = add_dynamic(world, {}, kBox);
        world.set_damping(body, kFaintDamping, kFaintDamping);
        world.set_velocity(body, {}, slow ? 0.070f : 0.0715f);
        CHECK((steps_until_asleep(world, body) == 30) == slow);
    }
}

TEST_CASE("what drifts through free space stays awake and keeps its speed; what touches a body at rest falls asleep") {
    for (const float speed : {0.04f, 1e-3f}) {
        CAPTURE(speed);
        World world = weightless();
        const BodyId alone = add_dynamic(world, {}, kBox), spinning = add_dynamic(world, {9.0, 0.0}, kBox);
        const std::vector<BodyId> pair{add_dynamic(world, {20.0, 0.0}, kBox), add_dynamic(world, {21.0, 0.0}, kBox)};
        world.set_velocity(alone, {speed, 0.0f}, 0.0f);
        world.set_velocity(spinning, {}, speed);
        for (const BodyId body : pair) world.set_velocity(body, {0.0f, speed}, 0.0f);
        run(world, 300);
        CHECK(near(world.state(alone).pose.position.x, 5.0 * static_cast<double>(speed), relative(1e-6)));
        CHECK(world.state(spinning).angular_velocity == speed);
        CHECK(all_awake(world, pair));
        const BodyId on_floor = add_dynamic(world, {0.0, 9.5}, kBox, {.friction = 0.0f});
        add_static(world, {0.0, 8.5}, make_box({99.0f, 1.0f}), {.friction = 0.0f});
        world.set_velocity(on_floor, {speed, 0.0f}, 0.0f);
        CHECK(steps_until_asleep(world, on_floor) >= 0);
    }
}

TEST_CASE("an island that touches the ground by one body falls asleep though another drifts on it") {
    World world = weightless();
    const BodyId rider = add_dynamic(world, {0.0, 1.5}, kBox, {.friction = 0.0f});
    const BodyId base = add_dynamic(world, {0.0, 0.5}, kBox, {.friction = 0.0f});
    add_static(world, {0.0, -0.5}, make_box({99.0f, 1.0f}), {.friction = 0.0f});
    world.set_velocity(rider, {0.04f, 0.0f}, 0.0f);
    CHECK(steps_until_asleep(world, rider) == 30);
    CHECK_FALSE(world.is_awake(base));
}

TEST_CASE("a body that drifts stays awake if only a filter joint connects it to a body at rest") {
    World world = weightless();
    const BodyId ground = world.create_body({.type = BodyType::static_body});
    const BodyId body = add_dynamic(world, {}, kBox);
    world.create_joint(FilterJointDef{.body_a = ground, .body_b = body});
    world.set_velocity(body, {0.04f, 0.0f}, 0.0f);
    run(world, 300);
    CHECK(near(world.state(body).pose.position.x, 0.2, relative(1e-6)));
}

TEST_CASE("a stack sleeps as one island, keeps its contacts, and costs no contact while asleep") {
    World world;
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 5);
    CHECK(steps_until_asleep(world, boxes[0]) > 30);
    CHECK(all_asleep(world, boxes));
    CHECK(world.counters().sleeping_islands == 1);
    CHECK(world.counters().awake_bodies == 0);
    CHECK(world.counters().contacts == 5);
    CHECK(world.contacts().size() == 10);
    world.step();
    CHECK(world.candidate_pairs().empty());
    CHECK(world.counters().colors == 0);
    CHECK(world.contacts().size() == 10);
    const DVec2 top = world.state(boxes.back()).pose.position;
    const std::uint64_t hash = world.state_hash();
    run(world, 100);
    CHECK(world.state(boxes.back()).pose.position == top);
    CHECK(world.state_hash() == hash);
    world.audit();
}

TEST_CASE("two separate boxes sleep and wake independently") {
    World world;
    add_floor(world);
    const BodyId left = add_dynamic(world, {-5.0, 0.5}, kBox);
    const BodyId right = add_dynamic(world, {5.0, 0.5}, kBox);
    run(world, 120);
    CHECK(world.counters().sleeping_islands == 2);
    world.set_awake(left, true);
    CHECK(world.is_awake(left));
    CHECK_FALSE(world.is_awake(right));
    run(world, 120);
    CHECK_FALSE(world.is_awake(left));
}

TEST_CASE("one body that may not sleep keeps its island awake, and no other island") {
    World world;
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 2);
    BodyDef restless;
    restless.pose.position = {0.0, 2.5};
    restless.allow_sleep = false;
    world.add_shape(world.create_body(restless), {.shape = kBox});
    const BodyId apart = add_dynamic(world, {5.0, 0.5}, kBox);
    run(world, 600);
    CHECK(all_awake(world, boxes));
    CHECK_FALSE(world.is_awake(apart));
}

TEST_CASE("without WorldDef::sleeping bodies sleep only by set_awake") {
    WorldDef def;
    def.sleeping = false;
    World world(def);
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 2);
    run(world, 300);
    CHECK(all_awake(world, boxes));
    world.set_awake(boxes[1], false);
    CHECK(all_asleep(world, boxes));
    run(world, 300);
    CHECK(all_asleep(world, boxes));
}

TEST_CASE("a body cannot be created asleep with a velocity") {
    World world;
    BodyDef def;
    def.awake = false;
    def.velocity = {1.0f, 0.0f};
    CHECK_THROWS_AS(world.create_body(def), std::invalid_argument);
}

TEST_CASE("the hash includes the sleep flags") {
    World awake = weightless(), asleep = weightless();
    const BodyId body = add_dynamic(awake, {}, kBox);
    add_dynamic(asleep, {}, kBox);
    asleep.set_awake(body, false);
    CHECK(awake.state(body).pose == asleep.state(body).pose);
    CHECK(awake.state_hash() != asleep.state_hash());
}

TEST_CASE("a contact that a filter excludes ends although its bodies fall asleep") {
    CollisionFilter apart;
    apart.group = -1;
    World world;
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 2);
    run(world, 10);
    for (const BodyId box : boxes) world.set_filter(world.shapes(box)[0], apart);
    for (const BodyId box : boxes) world.set_awake(box, false);
    world.audit();
    world.step();
    CHECK(world.events().contact_ends.size() == 1);
    for (const BodyId box : boxes) world.set_awake(box, true);
    run(world, 60);
    CHECK(std::abs(world.state(boxes[1]).pose.position.y - 0.5) < 0.01);
}

// At 1 Hz and up to 0.2 m/s it is slower than 0.05 m/s for 0.08 s at each end of its swing.
TEST_CASE("a body that swings does not add up the moments in which it is slow") {
    World world = weightless();
    const BodyId wall = world.create_body({.type = BodyType::static_body});
    const BodyId body = add_dynamic(world, {2.0, 0.0}, kBox);
    world.create_joint(
        DistanceJointDef{.body_a = wall, .body_b = body, .length = 2.0f, .spring = JointSpring{1.0f, 0.0f}});
    world.set_velocity(body, {0.2f, 0.0f}, 0.0f);
    run(world, 360);
    CHECK(world.is_awake(body));
}
