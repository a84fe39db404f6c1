// Changes of bodies between steps.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

}  // namespace

TEST_CASE("set_transform ends contacts, wakes the bodies that rested on it, and begins new contacts") {
    World world;
    add_floor(world);
    const BodyId lower = add_dynamic(world, {0.0, 0.5}, kBox), upper = add_dynamic(world, {0.0, 1.5}, kBox);
    const BodyId other = add_dynamic(world, {8.0, 0.5}, kBox);
    run(world, 120);
    REQUIRE_FALSE(world.is_awake(upper));
    REQUIRE_FALSE(world.is_awake(other));
    world.set_transform(lower, {{8.0, 1.5}, make_rotation(0.0)});
    CHECK(world.is_awake(lower));
    CHECK(world.is_awake(upper));
    world.step();
    CHECK_FALSE(touches(world, lower, upper));
    CHECK(touches(world, lower, other));
    CHECK(world.is_awake(other));
    CHECK(world.events().contact_ends.size() == 2);  // the floor and the upper box
    run(world, 120);
    CHECK(near(world.state(upper).pose.position.y, 0.5, absolute(kRestingDepth)));
    world.audit();
}

TEST_CASE("a body created with its shapes equals one that gets them one by one, at the velocity of its definition") {
    const std::vector<ShapeDef> shapes{
        {.shape = kBox}, {.shape = make_circle(0.5f, {2.0f, 1.0f})}, {.shape = kBox, .sensor = true}};
    for (const float spin : {0.0f, 3.0f}) {
        CAPTURE(spin);
        const BodyDef def{.pose = {{1.0, 2.0}, make_rotation(0.3)}, .velocity = {4.0f, 5.0f}, .angular_velocity = spin};
        World at_once, one_by_one;
        const BodyId whole = at_once.create_body(def, shapes), grown = one_by_one.create_body(def);
        for (const ShapeDef& shape : shapes) one_by_one.add_shape(grown, shape);
        CHECK(at_once.mass(whole) == one_by_one.mass(grown));
        CHECK(at_once.shapes(whole).size() == 3);
        CHECK(at_once.state(whole).velocity == def.velocity);
        // Shapes that are added later move the centre of mass, which has another velocity if the body rotates.
        CHECK((one_by_one.state(grown).velocity == def.velocity) == (spin == 0.0f));
        one_by_one.set_velocity(grown, def.velocity, spin);
        run(at_once, 10);
        run(one_by_one, 10);
        CHECK(at_once.state_hash() == one_by_one.state_hash());
        at_once.audit();
    }
    World world;
    CHECK_THROWS_AS(world.create_body({}, std::vector<ShapeDef>{{.shape = kBox}, {}}), std::invalid_argument);
    CHECK(world.bodies().empty());
    const BodyId asleep = world.create_body({.awake = false}, shapes),
                 off = world.create_body({.enabled = false}, shapes);
    CHECK_FALSE(world.is_awake(asleep));
    CHECK(world.shapes(off).size() == 3);
    world.audit();
}

TEST_CASE("moving a static body drops the bodies that rested on it, and wakes those at its new pose") {
    World world;
    const BodyId shelf = add_static(world, {0.0, 0.0}, make_box({2.0f, 0.2f}));
    add_floor(world);
    const BodyId box = add_dynamic(world, {0.0, 0.6}, kBox), beside = add_dynamic(world, {10.0, 0.5}, kBox);
    run(world, 120);
    REQUIRE_FALSE(world.is_awake(box));
    world.set_transform(shelf, {{11.3, 0.5}, {}});
    CHECK(world.is_awake(box));
    CHECK(world.is_awake(beside));
    run(world, 120);
    CHECK(near(world.state(box).pose.position.y, 0.5, absolute(kRestingDepth)));
    CHECK(near(world.state(beside).pose.position.x, 9.8, absolute(kRestingDepth)));  // pushed out to its edge
}

TEST_CASE("a disabled body has no contacts, no acting joints, and is in no query") {
    World world;
    add_floor(world);
    const BodyId shelf = add_static(world, {0.0, 3.0}, make_box({4.0f, 0.2f}));
    const BodyId box = add_dynamic(world, {0.0, 3.6}, kBox);
    const BodyId bob = add_dynamic(world, {8.0, 5.0}, kBox);
    world.create_joint(RevoluteJointDef{.body_a = shelf, .body_b = bob, .anchor_a = {8.0f, 2.0f}});
    run(world, 90);
    CHECK(near(world.state(bob).pose.position.y, 5.0, absolute(kRestingDepth)));
    world.set_enabled(shelf, false);
    CHECK_FALSE(world.is_enabled(shelf));
    CHECK_FALSE(world.cast_ray({1.5, 5.0}, {0.0, -3.0}));
    world.step();
    CHECK(world.events().contact_ends.size() == 1);
    run(world, 120);
    CHECK(near(world.state(box).pose.position.y, 0.5, absolute(kRestingDepth)));
    CHECK(near(world.state(bob).pose.position.y, 0.5, absolute(kRestingDepth)));
    world.audit();
    world.set_enabled(shelf, true);
    CHECK(world.cast_ray({1.5, 5.0}, {0.0, -3.0}));
    run(world, 240);
    CHECK(near(world.state(bob).pose.position.y, 5.0, absolute(kRestingDepth)));  // the hinge pulled it up again
}

TEST_CASE("a disabled dynamic body keeps its pose, and is at rest when it is enabled again") {
    World world;
    const BodyId body = add_dynamic(world, {0.0, 10.0}, kBox);
    run(world, 30);
    const DVec2 position = world.state(body).pose.position;
    world.set_enabled(body, false);
    run(world, 30);
    CHECK(world.state(body).pose.position == position);
    CHECK(world.type(body) == BodyType::dynamic_body);
    CHECK(world.mass(body).mass == 0.0f);
    world.set_enabled(body, true);
    run(world, 30);
    CHECK(near(world.state(body).velocity.y, -5.0, float_sum(240)));
}

TEST_CASE("a body may change its type at any time") {
    World world;
    add_floor(world);
    const BodyId body = add_dynamic(world, {0.0, 5.0}, kBox), load = add_dynamic(world, {0.0, 8.0}, kBox);
    run(world, 20);
    world.set_type(body, BodyType::static_body);
    const DVec2 position = world.state(body).pose.position;
    run(world, 120);
    CHECK(world.state(body).pose.position == position);
    CHECK(touches(world, body, load));
    world.set_type(body, BodyType::kinematic_body);
    world.set_velocity(body, {1.0f, 0.0f}, 0.0f);
    run(world, 60);
    CHECK(near(world.state(body).pose.position.x, 1.0, float_sum(240)));
    CHECK(world.state(load).pose.position.x > 0.5);  // carried by friction
    world.set_type(body, BodyType::dynamic_body);
    CHECK(world.mass(body).mass == 1.0f);
    run(world, 180);
    CHECK(near(world.state(body).pose.position.y, 0.5, absolute(kRestingDepth)));
    world.audit();
}

// F = m a with the mass that was set: 6 N on 3 kg for a second.
TEST_CASE("a mass that is set replaces the mass of the shapes") {
    World world = weightless();
    BodyDef def;
    def.mass = BodyMass{3.0f, {0.1f, 0.0f}, 2.0f};
    const BodyId body = world.create_body(def);
    world.add_shape(body, {kBox});
    CHECK(world.mass(body) == *def.mass);
    for (int step = 0; step < 60; ++step) {
        world.apply_force(body, {6.0f, 0.0f}, world.state(body).pose.position + DVec2{0.1, 0.0});
        world.step();
    }
    CHECK(near(world.state(body).velocity.x, 2.0, float_sum(240)));
    world.set_mass(body, std::nullopt);
    CHECK(world.mass(body).mass == 1.0f);
    CHECK(world.definition(body).mass == std::nullopt);
}

TEST_CASE("gravity, its scale and damping change between steps") {
    World world;
    const BodyId light = add_dynamic(world, {0.0, 0.0}, kBox), slow = add_dynamic(world, {5.0, 0.0}, kBox);
    world.set_gravity_scale(light, 0.5f);
    world.set_damping(slow, 2.0f, 0.0f);
    run(world, 60);
    CHECK(near(world.state(light).velocity.y, -5.0, float_sum(240)));
    // v' = -g - c v from rest: -g / c (1 - e^(-c t)).
    CHECK(near(world.state(slow).velocity.y, -10.0 / 2.0 * (1.0 - std::exp(-2.0)), float_sum(240)));
    world.set_gravity({0.0f, 5.0f});
    CHECK(world.def().gravity == Vec2{0.0f, 5.0f});
    run(world, 60);
    CHECK(near(world.state(light).velocity.y, -2.5, float_sum(480)));
}

TEST_CASE("the definition of a body creates an equal body") {
    World world;
    BodyDef def;
    def.pose = {{1.0, 2.0}, make_rotation(0.5)};
    def.velocity = {3.0f, 4.0f};
    def.angular_velocity = 1.0f;
    def.linear_damping = 0.1f;
    def.angular_damping = 0.2f;
    def.gravity_scale = 0.3f;
    def.allow_fast_rotation = true;
    def.bullet = true;
    def.allow_sleep = false;
    def.mass = BodyMass{2.0f, {}, 1.0f};
    const BodyDef same = world.definition(world.create_body(def));
    CHECK(same.pose == def.pose);
    CHECK(same.velocity == def.velocity);
    CHECK(same.angular_velocity == def.angular_velocity);
    CHECK(same.linear_damping == def.linear_damping);
    CHECK(same.angular_damping == def.angular_damping);
    CHECK(same.gravity_scale == def.gravity_scale);
    CHECK(same.allow_fast_rotation);
    CHECK(same.bullet);
    CHECK_FALSE(same.allow_sleep);
    CHECK(same.awake);
    CHECK(same.enabled);
    CHECK(same.mass == def.mass);
    CHECK(same.locks == BodyLocks{});
}

TEST_CASE("a definition contains locks, type, and whether a body is enabled or awake") {
    World world;
    const auto again = [&](const BodyDef& def) {
        return world.definition(world.create_body(world.definition(world.create_body(def))));
    };
    BodyDef locked;
    locked.locks = {.y = true, .rotation = true};
    locked.mass = BodyMass{1.0f, {}, 1.0f};
    CHECK(again(locked).locks == locked.locks);
    CHECK(again(locked).type == BodyType::dynamic_body);
    CHECK(again({.type = BodyType::kinematic_body, .velocity = {1.0f, 2.0f}}).type == BodyType::kinematic_body);
    CHECK(again({.type = BodyType::kinematic_body, .velocity = {1.0f, 2.0f}}).velocity == Vec2{1.0f, 2.0f});
    CHECK(again({.type = BodyType::static_body}).type == BodyType::static_body);
    BodyDef asleep;
    asleep.awake = false;
    CHECK_FALSE(again(asleep).awake);
    BodyDef disabled;
    disabled.enabled = false;
    CHECK_FALSE(again(disabled).enabled);
    CHECK(again(disabled).type == BodyType::dynamic_body);
}

TEST_CASE("invalid changes of a body throw and change nothing") {
    World world;
    const BodyId body = add_dynamic(world, {0.0, 5.0}, kBox);
    const ShapeId shape = world.shapes(body)[0];
    world.step();
    const std::vector<std::byte> before = world.save();
    const float nan = std::nanf("");
    CHECK_THROWS_AS(world.set_transform(body, {{nan, 0.0}, {}}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_transform(body, {{0.0, 0.0}, {2.0f, 0.0f}}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_mass(body, BodyMass{0.0f, {}, 1.0f}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_mass(body, BodyMass{1.0f, {}, -1.0f}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_damping(body, -1.0f, 0.0f), std::invalid_argument);
    CHECK_THROWS_AS(world.set_gravity_scale(body, nan), std::invalid_argument);
    CHECK_THROWS_AS(world.set_gravity({nan, 0.0f}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_material(shape, {.friction = -1.0f}), std::invalid_argument);
    CHECK_THROWS_AS(world.set_enabled(BodyId{99, 0}, true), std::invalid_argument);
    CHECK_THROWS_AS(world.remove_shape(ShapeId{99, 0}), std::invalid_argument);
    CHECK(world.save() == before);
}

TEST_CASE("a force or an impulse at the centre of mass does not rotate a body") {
    World world = weightless();
    BodyDef def;
    def.pose = {{3.0, 4.0}, make_rotation(0.5)};
    const BodyId body = world.create_body(def);
    world.add_shape(body, {.shape = make_box({1.0f, 1.0f}, 0.0f, {2.0f, 1.0f})});
    world.apply_impulse(body, {2.0f, -1.0f});
    world.apply_force(body, {60.0f, 0.0f});
    world.step();
    CHECK(world.state(body).angular_velocity == 0.0f);
    CHECK(std::abs(world.state(body).velocity.x - 3.0f) < 1e-5f);  // 1 kg: 2 m/s and 60 N for 1/60 s
    CHECK(world.state(body).velocity.y == -1.0f);
}

// A body of 2 kg and 3 kg m^2, whose centre of mass is (0, 1) from its origin, turned by a quarter: the centre is at
// (4, 6).
TEST_CASE("energy and momentum are those of the dynamic bodies") {
    World world(WorldDef{.gravity = {0.0f, -10.0f}});
    BodyDef def;
    def.pose = {{5.0, 6.0}, Rotation{0.0f, 1.0f}};
    def.gravity_scale = 0.5f;
    def.mass = BodyMass{2.0f, {0.0f, 1.0f}, 3.0f};
    const BodyId body = world.create_body(def);
    world.set_velocity(body, {3.0f, 4.0f}, 2.0f);
    BodyDef kinematic;
    kinematic.type = BodyType::kinematic_body;
    kinematic.velocity = {1.0f, 0.0f};
    const BodyId mover = world.create_body(kinematic);
    const Energy energy = world.energy(body);
    CHECK(energy.kinetic == 0.5 * 2.0 * 25.0 + 0.5 * 3.0 * 4.0);
    CHECK(energy.potential == 2.0 * 0.5 * 10.0 * 6.0);
    CHECK(world.energy(mover).total() == 0.0);
    CHECK(world.energy().total() == energy.total());
    CHECK(length(world.momentum() - DVec2{6.0, 8.0}) == 0.0);
    world.destroy_body(body);
    CHECK_THROWS_AS(world.energy(body), std::invalid_argument);
    CHECK(world.energy().total() == 0.0);
}

TEST_CASE("move_towards reaches a pose in one step, by the shorter rotation") {
    for (const BodyType type : {BodyType::kinematic_body, BodyType::dynamic_body}) {
        World world = weightless();
        const BodyId body = add_body(world, type, {1.0, 2.0}, make_box({1.0f, 1.0f}, 0.0f, {0.5f, 0.0f}), {}, 3.0);
        const Pose target{{1.1, 1.8}, make_rotation(-3.0)};  // 0.283 rad farther, through half a turn
        world.move_towards(body, target);
        CHECK(std::abs(world.state(body).angular_velocity - 60.0 * (2.0 * kPi - 6.0)) < 1e-3);
        world.step();
        const Pose now = world.state(body).pose;
        CHECK(length(now.position - target.position) < 1e-5);
        CHECK(std::abs(angle(now.rotation) + 3.0) <
              1e-4);  // a small turn of the sub-steps has an error of the third order
    }
    World world;
    CHECK_THROWS_AS(world.move_towards(add_floor(world), Pose{}), std::invalid_argument);
}

TEST_CASE("the joints and the contacts of a body are listed") {
    World world;
    const BodyId floor = add_floor(world);
    const BodyId lower = add_dynamic(world, {0.0, 0.5}, kBox), upper = add_dynamic(world, {0.0, 1.5}, kBox);
    const BodyId apart = add_dynamic(world, {5.0, 0.5}, kBox);
    const JointId first = world.create_joint(MouseJointDef{.body_a = floor, .body_b = lower});
    const JointId second = world.create_joint(MouseJointDef{.body_a = lower, .body_b = apart});
    CHECK(std::vector<JointId>(world.joints(lower).begin(), world.joints(lower).end()) == std::vector{first, second});
    CHECK(world.joints(upper).empty());
    world.step();
    CHECK(world.contacts().size() == 6);
    CHECK(world.contacts(floor).size() == 4);
    CHECK(world.contacts(lower).size() == 4);
    REQUIRE(world.contacts(upper).size() == 2);
    for (const ContactPoint& point : world.contacts(upper)) CHECK(point.body_a == lower);
    world.destroy_body(upper);
    CHECK(world.contacts(lower).size() == 2);
    CHECK_THROWS_AS(world.contacts(upper), std::invalid_argument);
    CHECK_THROWS_AS(world.joints(upper), std::invalid_argument);
}

// Whatever the body and the state, the contacts of one body are those of the whole report that name it.
TEST_CASE("the contacts of a body are its part of all contacts") {
    World world;
    const BodyId floor = world.create_body({.type = BodyType::static_body});
    world.add_shape(floor, {.shape = make_box({40, 1})});
    const BodyId alone = world.create_body({.pose = {{15.0, 1.0}, {}}});  // sleeps in an island of its own
    world.add_shape(alone, {.shape = make_box({1, 1})});
    std::vector<BodyId> bodies{floor, alone};
    for (int i = 0; i < 60; ++i) {
        bodies.push_back(world.create_body({.pose = {{(i % 6) * 1.1 - 3.0, 1.0 + i / 6 * 1.2}, {}}}));
        world.add_shape(bodies.back(), {.shape = i % 3 == 0 ? make_circle(0.5f) : make_box({1, 1})});
    }
    const auto check_all = [&] {
        const std::vector<ContactPoint> all = world.contacts();
        for (const BodyId body : bodies) {
            std::vector<ContactPoint> expected;
            for (const ContactPoint& point : all)
                if (point.body_a == body || point.body_b == body) expected.push_back(point);
            const std::vector<ContactPoint> found = world.contacts(body);
            REQUIRE(found.size() == expected.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                CHECK(found[i].shape_a == expected[i].shape_a);
                CHECK(found[i].shape_b == expected[i].shape_b);
                CHECK(found[i].feature == expected[i].feature);
            }
        }
        return all.size();
    };
    for (int step = 0; step < 400; ++step) {
        world.step();
        if (step % 20 == 0 || step == 399) check_all();
    }
    CHECK(world.counters().sleeping_islands > 0);
    CHECK(check_all() > 50);
    world.set_awake(bodies[9], true);  // its contacts wait to be sorted in
    check_all();
    world.set_transform(bodies[10], {{50.0, 50.0}, {}});  // its contacts end in the next step
    check_all();
    world.set_enabled(bodies[11], false);
    check_all();
    world.step();
    check_all();
}
