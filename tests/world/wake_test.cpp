// What wakes sleeping bodies, what does not, and that they go on as if they had not slept.
#include <doctest/doctest.h>

#include <vector>

#include "support/near.hpp"
#include "support/sleepers.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("a ball that hits a sleeping stack wakes all of it, in the step in which it is stopped") {
    World world;
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 3);
    run(world, 120);
    REQUIRE(all_asleep(world, boxes));
    const BodyId ball = add_dynamic(world, {-6.0, 2.5}, make_circle(0.3f), {.density = 5.0f});
    world.set_velocity(ball, {12.0f, 2.0f}, 0.0f);
    for (int step = 0; step < 60 && !world.is_awake(boxes[2]); ++step) {
        CHECK(world.state(ball).velocity.x > 11.9f);
        world.step();
        world.audit();
    }
    CHECK(all_awake(world, boxes));
    CHECK(world.state(ball).velocity.x < 11.0f);
    CHECK(world.state(boxes[2]).velocity.x > 0.1f);
}

TEST_CASE("waking spreads through bodies that were created asleep, within one step") {
    World world = weightless();
    std::vector<BodyId> row;
    for (int i = 0; i < 20; ++i) {
        BodyDef def;
        def.pose.position = {1.0 * i, 0.0};
        def.awake = false;
        row.push_back(world.create_body(def));
        world.add_shape(row.back(), {.shape = kBox});
    }
    world.step();
    CHECK(all_asleep(world, row));
    CHECK(world.counters().sleeping_islands == 20);
    const BodyId ball = add_dynamic(world, {-1.05, 0.0}, make_circle(0.5f));
    world.set_velocity(ball, {6.0f, 0.0f}, 0.0f);
    for (int step = 0; step < 60 && !world.is_awake(row[0]); ++step) world.step();
    CHECK(all_awake(world, row));
    world.audit();
}

TEST_CASE("a body that wakes stands on its floor in the same step") {
    World world;
    add_floor(world);
    BodyDef sleeper;
    sleeper.pose.position = {0.0, 0.5};
    sleeper.awake = false;
    const BodyId box = world.create_body(sleeper);
    world.add_shape(box, {.shape = kBox});
    BodyDef lift;
    lift.type = BodyType::kinematic_body;
    lift.pose.position = {1.0, 0.8};
    lift.velocity = {0.0f, 1.0f};
    world.add_shape(world.create_body(lift), {.shape = kBox, .material = {.friction = 0.0f}});
    world.step();
    CHECK(world.is_awake(box));
    // Falling for one step, it would have 0.16 m/s.
    CHECK(near(world.state(box).velocity.y, 0.0, absolute(1e-6)));
    CHECK(near(world.state(box).pose.position.y, 0.5, absolute(kRestingDepth)));
    world.audit();
}

TEST_CASE("bodies that rest on a body wake when it is destroyed, static or not") {
    World world;
    const BodyId floor = add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 3);
    run(world, 120);
    REQUIRE(all_asleep(world, boxes));
    world.destroy_body(boxes[1]);
    CHECK(world.is_awake(boxes[0]));
    CHECK(world.is_awake(boxes[2]));
    world.audit();
    run(world, 180);
    // It falls asleep while it still settles, at less than 0.05 m/s.
    CHECK(near(world.state(boxes[2]).pose.position.y, 1.5, absolute(0.002)));
    REQUIRE_FALSE(world.is_awake(boxes[2]));
    world.destroy_body(floor);
    CHECK(world.is_awake(boxes[2]));
    run(world, 60);
    world.audit();
    CHECK(world.state(boxes[0]).pose.position.y < -3.0);
}

TEST_CASE("a kinematic lift at rest lets its load sleep, and wakes and carries it when it starts") {
    World world;
    const BodyId lift = add_body(world, BodyType::kinematic_body, {}, make_box({4.0f, 1.0f}));
    const BodyId load = add_dynamic(world, {0.0, 1.0}, kBox);
    run(world, 120);
    REQUIRE_FALSE(world.is_awake(load));
    world.set_velocity(lift, {0.0f, 0.02f}, 0.0f);  // slower than what counts as rest
    CHECK(world.is_awake(load));
    run(world, 600);
    CHECK(world.is_awake(load));
    CHECK(near(world.state(load).pose.position.y, 1.2, absolute(kRestingDepth)));
    world.set_velocity(lift, {}, 0.0f);
    run(world, 120);
    CHECK_FALSE(world.is_awake(load));
}

TEST_CASE("a kinematic lift that starts beside a sleeping body collides with it") {
    World world = weightless();
    const BodyId lift = add_body(world, BodyType::kinematic_body, {}, kBox);
    const BodyId load = add_dynamic(world, {1.07, 0.0}, kBox);  // boxes with margins overlap, contacts begin at 2 cm
    run(world, 60);
    REQUIRE_FALSE(world.is_awake(load));
    world.set_velocity(lift, {1.0f, 0.0f}, 0.0f);
    run(world, 60);
    CHECK(world.is_awake(load));
    CHECK(near(world.state(load).pose.position.x, 2.0, kFloat));
    world.audit();
}

TEST_CASE("pairs that do not touch are found again when their bodies wake") {
    World world = weightless();
    const BodyId left = add_dynamic(world, {}, kBox);
    const BodyId right = add_dynamic(world, {1.04, 0.0}, kBox);
    run(world, 60);
    REQUIRE_FALSE(world.is_awake(left));
    CHECK(world.counters().sleeping_islands == 2);
    world.set_velocity(left, {1.0f, 0.0f}, 0.0f);
    run(world, 30);
    CHECK(world.state(right).velocity.x > 0.4f);  // half of the momentum each
    world.audit();
}

TEST_CASE("forces, impulses and joints wake a body") {
    World world = weightless();
    const BodyId a = add_dynamic(world, {}, kBox), b = add_dynamic(world, {3.0, 0.0}, kBox);
    const auto sleep = [&] {
        world.set_awake(a, false);
        world.set_awake(b, false);
    };
    sleep();
    world.apply_force(a, {1.0f, 0.0f}, {});
    CHECK(world.is_awake(a));
    sleep();
    world.apply_torque(a, 1.0f);
    CHECK(world.is_awake(a));
    sleep();
    world.apply_impulse(a, {1.0f, 0.0f}, {});
    CHECK(world.is_awake(a));
    sleep();
    world.apply_angular_impulse(a, 1.0f);
    CHECK(world.is_awake(a));
    CHECK_FALSE(world.is_awake(b));
    const JointId rod = world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length = 3.0f});
    CHECK(world.is_awake(b));
    sleep();
    world.destroy_joint(rod);
    CHECK(world.is_awake(a));
    CHECK(world.is_awake(b));
    world.audit();
}

TEST_CASE("sleeping bodies that are joined stay asleep and become one island") {
    World world;
    std::vector<BodyId> links;
    for (int i = 0; i < 4; ++i) {
        BodyDef def;
        def.pose.position = {1.0 * i, 0.0};
        def.awake = false;
        links.push_back(world.create_body(def));
        world.add_shape(links.back(), {.shape = kBox});
        if (i > 0)
            world.create_joint(RevoluteJointDef{.body_a = links[links.size() - 2],
                                                .body_b = links.back(),
                                                .anchor_a = {0.5f, 0.0f},
                                                .anchor_b = {-0.5f, 0.0f}});
    }
    run(world, 10);
    world.audit();
    CHECK(all_asleep(world, links));
    CHECK(world.counters().sleeping_islands == 1);
    CHECK(world.state(links[0]).pose.position.y == 0.0);
    world.set_awake(links[3], true);
    CHECK(all_awake(world, links));
    run(world, 10);
    CHECK(world.state(links[0]).pose.position.y < -0.1);
}

TEST_CASE("a stack that wakes continues as if it had not slept") {
    World slept, stayed;
    std::vector<BodyId> boxes;
    for (World* world : {&slept, &stayed}) {
        add_floor(*world);
        boxes = add_stack(*world, 5);
        run(*world, 200);
    }
    REQUIRE(all_asleep(slept, boxes));
    REQUIRE(all_asleep(stayed, boxes));
    run(slept, 100);
    for (World* world : {&slept, &stayed}) {
        world->set_awake(boxes[0], true);
        world->step();
    }
    // The stored impulses carry the stack: 5 m g dt on the ground in the very first step.
    double carried = 0.0;
    for (const ContactPoint& point : slept.contacts())
        if (point.body_b == boxes[0] || point.body_a == boxes[0])
            if (point.separation < 0.0f && point.point.y < 0.5) carried += double{point.normal_impulse};
    CHECK(near(carried, 5.0 * 10.0 / 60.0, relative(0.001)));
    for (World* world : {&slept, &stayed}) run(*world, 10);
    CHECK(slept.state_hash() == stayed.state_hash());
}

TEST_CASE("a body that is moved and put to sleep there leaves its former neighbours awake") {
    World world;
    add_floor(world);
    const std::vector<BodyId> boxes = add_stack(world, 2);
    run(world, 30);
    world.set_transform(boxes[0], {{50.0, 50.0}, {}});
    world.set_awake(boxes[0], false);
    world.audit();
    CHECK(world.is_awake(boxes[1]));
    world.step();
    // With the floor and with the upper box: the next step ends them, asleep or not.
    CHECK(world.events().contact_ends.size() == 2);
    world.audit();
    run(world, 60);
    CHECK_FALSE(world.is_awake(boxes[0]));
    CHECK(std::abs(world.state(boxes[1]).pose.position.y - 0.5) < 0.01);
}

TEST_CASE("a joint that excludes the contact of two sleeping bodies wakes them") {
    for (const bool joins_floor : {false, true}) {
        World world;
        const BodyId floor = add_floor(world);
        const std::vector<BodyId> boxes = add_stack(world, 2);
        run(world, 200);
        REQUIRE(all_asleep(world, boxes));
        world.create_joint(FilterJointDef{joins_floor ? floor : boxes[1], boxes[0]});
        CHECK(all_awake(world, boxes));
        world.step();
        CHECK(world.events().contact_ends.size() == 1);
        world.audit();
        run(world, 60);  // 5 m of fall
        CHECK(world.state(boxes[joins_floor ? 0 : 1]).pose.position.y < (joins_floor ? -4.0 : 0.51));
    }
}

TEST_CASE("a sleeping body wakes when a static body that it touches is destroyed, in either order of the two") {
    for (const bool static_first : {true, false}) {
        CAPTURE(static_first);
        World world;
        BodyId shelf, box;
        if (static_first) shelf = add_static(world, {0.0, -0.5}, make_box({4.0f, 1.0f}));
        box = add_dynamic(world, {0.0, 0.5}, kBox);
        if (!static_first) shelf = add_static(world, {0.0, -0.5}, make_box({4.0f, 1.0f}));
        run(world, 120);
        REQUIRE_FALSE(world.is_awake(box));
        world.destroy_body(shelf);
        CHECK(world.is_awake(box));
    }
}
