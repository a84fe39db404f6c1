// Events: each begin event has its end event in the right step, with the numbers of the impact. Filters.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});

BodyId add_filtered(World& world, DVec2 position, const CollisionFilter& filter) {
    BodyDef def;
    def.pose.position = position;
    const BodyId body = world.create_body(def);
    world.add_shape(body, {.shape = kBox, .filter = filter});
    return body;
}

// Tracks begins and ends, and fails on an end without a begin, on a second begin, or on a hit of shapes that do not
// touch.
struct Ledger {
    std::set<std::pair<ShapeId, ShapeId>> touching;
    int begins = 0;

    void read(const World& world) {
        for (const ContactEnd& end : world.events().contact_ends)
            CHECK(touching.erase({end.shape_a, end.shape_b}) == 1);
        for (const ContactBegin& begin : world.events().contact_begins) {
            CHECK(touching.insert({begin.shape_a, begin.shape_b}).second);
            ++begins;
        }
        for (const ContactHit& hit : world.events().contact_hits)
            CHECK(touching.count({hit.shape_a, hit.shape_b}) == 1);
        CHECK(std::is_sorted(world.events().contact_ends.begin(), world.events().contact_ends.end()));
    }
};

}  // namespace

TEST_CASE("a dropped ball begins to touch in the step that stops it, with the speed of its fall") {
    World world;
    add_floor(world);
    const BodyId ball = add_dynamic(world, {2.0, 3.0}, make_circle(0.5f));
    for (int step = 0; step < 120; ++step) {
        const float before = world.state(ball).velocity.y;
        world.step();
        // The step that begins within the reach of gravity moves it to the floor.
        const bool stopped = world.state(ball).velocity.y > -0.1f && before < -1.0f;
        CHECK(world.events().contact_begins.size() == (stopped ? 1u : 0u));
        if (!stopped) continue;
        REQUIRE(world.events().contact_begins.size() == 1);
        const ContactBegin& hit = world.events().contact_begins[0];
        CHECK(world.body(hit.shape_b) == ball);
        CHECK(hit.normal == Vec2{0.0f, 1.0f});
        CHECK(near(hit.approach_speed, std::sqrt(2.0 * 10.0 * 2.5), float_sum(172)));
        CHECK(std::abs(hit.point.x - 2.0) < 1e-6);
        CHECK(std::abs(hit.point.y) < 0.06);  // half of what it falls in a step
    }
    CHECK(world.events().contact_ends.empty());
}

TEST_CASE("a bouncing ball begins and ends a contact once in each bounce") {
    World world;
    add_floor(world, {.restitution = 0.8f});
    add_dynamic(world, {0.0, 3.0}, make_circle(0.5f), {.restitution = 0.8f});
    Ledger ledger;
    int ends = 0;
    for (int step = 0; step < 150; ++step) {
        world.step();
        ledger.read(world);
        ends += static_cast<int>(world.events().contact_ends.size());
    }
    // Falls at 0.71 s, then every 2 * 0.8^n * 0.71 s: 1.84 s and 2.75 s; two bounces in 2.5 s.
    CHECK(ledger.begins == 2);
    CHECK(ends == 2);
}

TEST_CASE("destroying a touching body ends its contacts, asleep or awake") {
    for (const int wait : {20, 120}) {
        World world;
        const BodyId floor = add_floor(world);
        const BodyId box = add_dynamic(world, {0.0, 0.5}, kBox);
        const ShapeId floor_shape = world.shapes(floor)[0], box_shape = world.shapes(box)[0];
        run(world, wait);
        CHECK(world.is_awake(box) == (wait == 20));
        world.destroy_body(wait == 20 ? box : floor);
        const BodyId next = add_dynamic(world, {0.0, 5.0}, kBox);  // takes the index, not the contact
        CHECK(world.shapes(next)[0] != box_shape);
        world.step();
        REQUIRE(world.events().contact_ends.size() == 1);
        CHECK(world.events().contact_ends[0] == ContactEnd{floor_shape, box_shape});
        CHECK(world.events().contact_begins.empty());
    }
}

TEST_CASE("in a heap every end event has its begin event, through sleep and destruction") {
    World world;
    add_floor(world);
    add_static(world, {-5.0, 3.0}, make_box({1.0f, 6.0f}));
    add_static(world, {5.0, 3.0}, make_box({1.0f, 6.0f}));
    std::mt19937 random(3);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 40; ++i)
        bodies.push_back(add_dynamic(world, {-3.5 + i % 8, 1.0 + i / 8}, i % 2 ? kBox : make_circle(0.4f),
                                     {.restitution = 0.5f}, 0.1 * i));
    Ledger ledger;
    for (int step = 0; step < 900; ++step) {
        if (step % 100 == 99) {
            const std::size_t victim = random() % bodies.size();
            world.destroy_body(bodies[victim]);
            bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(victim));
        }
        world.step();
        ledger.read(world);
    }
    // The remaining pairs are those that rest on each other.
    std::set<std::pair<ShapeId, ShapeId>> resting;
    for (const ContactPoint& point : world.contacts())
        if (point.separation <= 0.0f || point.normal_impulse > 0.0f) resting.insert({point.shape_a, point.shape_b});
    CHECK(ledger.touching == resting);
    CHECK(ledger.begins > 200);
}

// The upper box takes part in the impact of the lower one across the gap.
TEST_CASE("when two boxes land, the upper one faster, no contact has a hit before it begins") {
    for (int gap = 1; gap <= 20; ++gap)
        for (int phase = 0; phase < 5; ++phase) {
            World world;
            add_floor(world);
            const BodyId lower = add_dynamic(world, {0.0, 0.52 + 0.015 * phase}, kBox);
            const BodyId upper = add_dynamic(world, {0.0, 1.52 + 0.015 * phase + 1e-3 * gap}, kBox);
            world.set_velocity(lower, {0.0f, -5.0f}, 0.0f);
            world.set_velocity(upper, {0.0f, -6.5f}, 0.0f);
            Ledger ledger;
            std::size_t hits = 0;
            for (int step = 0; step < 60; ++step) {
                world.step();
                ledger.read(world);
                hits += world.events().contact_hits.size();
            }
            CHECK(ledger.begins >= 2);
            CHECK(hits >= 2);
        }
}

// The third ball takes part in the impact of the first two across the gap.
TEST_CASE(
    "in a row of balls with gaps a contact that passes an impulse on begins in that step, and has its hit in it") {
    for (const float restitution : {0.0f, 0.5f, 1.0f})
        for (int gap = 0; gap <= 20; ++gap) {
            World world = weightless();
            const SurfaceMaterial material{.friction = 0.3f, .restitution = restitution};
            const BodyId first = add_dynamic(world, {-0.6, 0.0}, make_circle(0.2f), material);
            add_dynamic(world, {}, make_circle(0.2f), material);
            const BodyId third = add_dynamic(world, {0.4 + 5e-4 * gap, 0.0}, make_circle(0.2f), material);
            world.set_velocity(first, {50.0f, 0.0f}, 0.0f);
            world.set_velocity(third, {-1.5f, 0.0f}, 0.0f);
            Ledger ledger;
            for (int step = 0; step < 10; ++step) {
                const float before = world.state(third).velocity.x;
                world.step();
                ledger.read(world);
                float impulse = 0.0f;
                for (const ContactPoint& point : world.contacts(third)) impulse += point.normal_impulse;
                CHECK(near(double{impulse}, double{world.mass(third).mass * (world.state(third).velocity.x - before)},
                           float_sum(100)));
                for (const ContactPoint& point : world.contacts())
                    CHECK((point.normal_impulse == 0.0f || ledger.touching.count({point.shape_a, point.shape_b}) == 1));
            }
            CHECK(ledger.begins >= 2);
        }
}

TEST_CASE("a ball that hits two walls in each step lists its contacts by body too, and ends them when it stops") {
    World world = weightless();
    const Shape wall = make_box({1.0f, 40.0f});
    add_static(world, {-2.0, 0.0}, wall);
    add_static(world, {2.0, 0.0}, wall);
    const BodyId ball = add_dynamic(world, {0.3, 0.0}, make_circle(0.2f), {.friction = 0.0f, .restitution = 1.0f});
    world.set_velocity(ball, {331.0f, 0.3f}, 0.0f);
    Ledger ledger;
    int steps_with_both = 0;
    for (int step = 0; step < 200; ++step) {
        world.step();
        ledger.read(world);
        std::set<ShapeId> pushed;
        for (const ContactPoint& point : world.contacts())
            if (point.normal_impulse > 0.0f) pushed.insert(point.shape_a);
        steps_with_both += pushed.size() == 2;
        CHECK(world.contacts(ball).size() == world.contacts().size());
    }
    CHECK(steps_with_both > 150);
    world.set_velocity(ball, {}, 0.0f);
    world.step();
    ledger.read(world);
    CHECK(ledger.touching.empty());
}

TEST_CASE("a joint sleeps if one of its bodies sleeps or is disabled") {
    World world = weightless();
    const BodyId a = add_dynamic(world, {}, kBox), b = add_dynamic(world, {2.0, 0.0}, kBox);
    const BodyId c = add_dynamic(world, {9.0, 0.0}, kBox), d = add_dynamic(world, {12.0, 0.0}, kBox);
    const JointId resting = world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length = 2.0f});
    const JointId moving = world.create_joint(DistanceJointDef{.body_a = c, .body_b = d, .length = 3.0f});
    world.set_velocity(c, {1.0f, 0.0f}, 0.0f);
    world.set_velocity(d, {1.0f, 0.0f}, 0.0f);
    CHECK(world.is_awake(resting));
    CHECK(world.is_awake(moving));
    run(world, 60);
    CHECK_FALSE(world.is_awake(a));
    CHECK_FALSE(world.is_awake(resting));
    CHECK(world.is_awake(moving));
    world.set_enabled(d, false);
    CHECK_FALSE(world.is_awake(moving));
    world.set_awake(a, true);
    world.set_enabled(d, true);
    CHECK(world.is_awake(resting));
    CHECK(world.is_awake(moving));
    world.destroy_joint(moving);
    CHECK_THROWS_AS(world.is_awake(moving), std::invalid_argument);
}

TEST_CASE("bodies that fall asleep are listed in that step") {
    World world = weightless();
    const BodyId a = add_dynamic(world, {}, kBox), b = add_dynamic(world, {5.0, 0.0}, kBox);
    world.set_velocity(b, {1.0f, 0.0f}, 0.0f);
    run(world, 29);
    CHECK(world.events().fell_asleep.empty());
    CHECK(world.awake_bodies() == std::vector<BodyId>{a, b});
    world.step();
    CHECK(world.events().fell_asleep == std::vector<BodyId>{a});
    CHECK(world.awake_bodies() == std::vector<BodyId>{b});
    world.step();
    CHECK(world.events().fell_asleep.empty());
}

TEST_CASE("filters: both masks must accept the other category, and groups override masks") {
    const CollisionFilter all{}, red{2, 1, 0}, blue{4, ~std::uint64_t{0}, 0};
    CHECK(may_touch(all, red));
    CHECK_FALSE(may_touch(red, blue));
    CHECK(may_touch(all, blue));
    CHECK_FALSE(may_touch({1, 1, -3}, {1, 1, -3}));
    CHECK(may_touch({1, 0, 5}, {1, 0, 5}));
    CHECK_FALSE(may_touch({1, 0, 5}, {1, 0, 6}));
    World world = weightless();
    const BodyId a = add_filtered(world, {}, red), b = add_filtered(world, {0.5, 0.0}, blue);
    const BodyId c = add_filtered(world, {1.0, 0.0}, all);
    world.step();
    CHECK(world.candidate_pairs().size() == 2);
    CHECK(world.state(c).pose.position.x > 1.01);  // pushed by b
    CHECK(world.state(b).pose.position.x < 0.49);
    CHECK(world.is_valid(a));
}

// Balls of 10 cm that fly at each other, 5 cm off the middle, are apart again within two steps; the phase is the time
// of the impact within a step. They touch for less than a step, and their boxes are apart at its end. Their contact
// shows the impulse in that step, and ends in the next.
TEST_CASE("a deflected body has a begin event, even if both are far apart at the end of the step") {
    int deflections = 0;
    for (int phase = 0; phase < 200; ++phase) {
        World world = weightless();
        BodyDef def;
        def.bullet = true;
        def.pose.position = {-2.0 - 0.05 * phase, 0.0};
        def.velocity = {300.0f, 0.0f};
        const BodyId left = world.create_body(def);
        world.add_shape(left, {.shape = make_circle(0.1f)});
        def.pose.position = {2.0, 0.05};
        def.velocity = {-150.0f, 0.0f};
        world.add_shape(world.create_body(def), {.shape = make_circle(0.1f)});
        std::size_t begins = 0, ends = 0;
        for (int step = 0; step < 10; ++step) {
            world.step();
            ends += world.events().contact_ends.size();
            CHECK(ends == begins);
            begins += world.events().contact_begins.size();
            float impulse = 0.0f;
            for (const ContactPoint& point : world.contacts()) impulse += point.normal_impulse;
            CHECK((impulse > 0.0f) == !world.events().contact_begins.empty());
        }
        const bool deflected = world.state(left).velocity != Vec2{300.0f, 0.0f};
        deflections += deflected;
        CHECK(begins == (deflected ? 1u : 0u));
        CHECK(ends == begins);
    }
    CHECK(deflections == 200);
}

TEST_CASE("a fast impact is a hit in the step in which it begins, a slow one is not") {
    for (const float speed : {0.9f, 1.1f, 20.0f, 300.0f}) {
        World world = weightless();
        add_static(world, {0.0, 0.0}, make_box({0.1f, 4.0f}));
        const BodyId ball = add_dynamic(world, {-2.0, 0.0}, make_circle(0.1f));
        world.set_velocity(ball, {speed, 0.0f}, 0.0f);
        std::size_t hits = 0;
        for (int step = 0; step < 200; ++step) {
            world.step();
            const StepEvents& events = world.events();
            hits += events.contact_hits.size();
            if (events.contact_hits.empty()) continue;
            REQUIRE(events.contact_begins.size() == 1);
            const ContactBegin& begin = events.contact_begins[0];
            const ContactHit& hit = events.contact_hits[0];
            CHECK(hit.approach_speed == speed);
            CHECK(hit.approach_speed == begin.approach_speed);
            CHECK(hit.point == begin.point);
            CHECK(hit.normal == begin.normal);
            CHECK(hit.shape_b == begin.shape_b);
        }
        CHECK(hits == (speed >= 1.0f ? 1u : 0u));
    }
}

// A plank of 2 m x 0.1 m that leans by 0.1 rad on its left edge falls over it. Its centre comes down by
// sin(0.1) m - 0.05 m (1 - cos(0.1)), so that w^2 = 2 g of that / k^2 with k^2 = (2^2 + 0.1^2) m^2 / 3, and its right
// edge hits the floor at 2 m w = 2.441 m/s, with an acceleration of at most 2 m g / k^2 = 15 m/s^2. The semi-implicit
// scheme is half a sub-step of that faster. The contact of the left edge pushes the plank, and the velocity of such a
// body is known at the ends of a step only: the reported speed is one of the step in which it hits, so up to a step of
// that slower.
TEST_CASE("the second end of a falling plank is a hit, although plank and floor touch already") {
    World world;
    add_floor(world);
    const double lean = 0.1;
    const SinCos q = sin_cos(lean);
    const BodyId plank = add_dynamic(world, {q.cos - 0.05 * q.sin, q.sin + 0.05 * q.cos}, make_box({2.0f, 0.1f}),
                                     {.friction = 1.0f}, lean);
    std::vector<ContactHit> hits;
    std::size_t begins = 0;
    for (int step = 0; step < 60; ++step) {
        world.step();
        hits.insert(hits.end(), world.events().contact_hits.begin(), world.events().contact_hits.end());
        begins += world.events().contact_begins.size();
    }
    CHECK(begins == 1);
    REQUIRE(hits.size() == 1);
    CHECK(world.body(hits[0].shape_b) == plank);
    CHECK(std::abs(hits[0].point.x - 2.0) < 5e-4);  // 2 m (1 - cos) of the 0.02 rad of the last step
    const double fall = std::sin(lean) - 0.05 * (1.0 - std::cos(lean)),
                 speed = 2.0 * std::sqrt(20.0 * fall * 3.0 / 4.01);
    CHECK(hits[0].approach_speed < speed + 15.0 / 480.0);
    CHECK(hits[0].approach_speed > speed - 15.0 / 60.0);
    run(world, 60);
    CHECK(world.events().contact_hits.empty());
}

TEST_CASE("a hit is reported with its own speed, not with that of an earlier one") {
    // A box with another on it lies on the floor, and is then thrown down at 3 m/s.
    World world;
    add_floor(world);
    const BodyId lower = add_dynamic(world, {0.0, 5.5}, make_box({1.0f, 1.0f}));
    add_dynamic(world, {0.0, 7.5}, make_box({1.0f, 1.0f}));
    run(world, 180);
    world.set_velocity(lower, {0.0f, -3.0f}, 0.0f);
    float fastest = 0.0f;
    for (int step = 0; step < 10; ++step) {
        world.step();
        for (const ContactHit& hit : world.events().contact_hits) fastest = std::max(fastest, hit.approach_speed);
    }
    CHECK(near(fastest, 3.0, relative(0.01)));
}
