// Joints solved directly, and pendulums with each of the solvers, against the exact mechanics of pendulums and chains,
// at 60 Hz and 4 sub-steps.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/near.hpp"
#include "support/pendulum.hpp"
#include "support/world_of_all_kinds.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kGravity = 10.0;

World direct_world(bool sleeping = true) {
    WorldDef def;
    def.joints = JointSolver::direct;
    def.sleeping = sleeping;
    return World(def);
}

struct Swing {
    double period = 0.0;     // mean of 100, s
    double amplitude = 0.0;  // after them, rad
};

// Both are interpolated: the passages through x = 0 linearly, the amplitude by a parabola through three steps.
Swing measure_swing(World& world, BodyId bob) {
    Swing swing;
    double first = 0.0, angle_before = 0.0, angle_two_before = 0.0, x_before = world.state(bob).pose.position.x;
    for (int step = 1, passages = 0; step < 60000; ++step) {
        world.step();
        const DVec2 position = world.state(bob).pose.position;
        const double angle = std::abs(std::atan2(position.x, -position.y));
        if (angle_before > angle_two_before && angle_before >= angle) {
            const double top = (angle_two_before - angle) / (2.0 * (angle_two_before - 2.0 * angle_before + angle));
            swing.amplitude = angle_before - 0.25 * (angle_two_before - angle) * top;
        }
        angle_two_before = angle_before;
        angle_before = angle;
        if ((x_before > 0.0) != (position.x > 0.0)) {
            const double time = (step - position.x / (position.x - x_before)) * double{kStep};
            if (++passages == 1) first = time;
            if (passages == 201) {
                swing.period = (time - first) / 100.0;
                return swing;
            }
        }
        x_before = position.x;
    }
    return swing;
}

// Kinetic energy, and potential energy against y = 0. Origins are centres of mass.
double energy(const World& world, const std::vector<BodyId>& bodies) {
    double sum = 0.0;
    for (const BodyId id : bodies) {
        const BodyState state = world.state(id);
        const BodyMass mass = world.mass(id);
        const DVec2 velocity(state.velocity);
        const double spin = state.angular_velocity;
        sum += double{mass.mass} * (kGravity * state.pose.position.y + 0.5 * dot(velocity, velocity)) +
               0.5 * double{mass.inertia} * spin * spin;
    }
    return sum;
}

struct Chain {
    World world;
    std::vector<BodyId> bodies;
    std::vector<RevoluteJointDef> joints;

    // `count` bars of 1 m that point along `angle`, and a ball of radius 2 and the given density at their end.
    Chain(int count, double angle, float density) : world(direct_world(false)) {
        const DVec2 along{std::cos(angle), std::sin(angle)};
        BodyId before = world.create_body({.type = BodyType::static_body});
        Vec2 anchor{};
        for (int i = 0; i < count; ++i) {
            add(before, anchor, (i + 0.5) * along, make_box({1.0f, 0.25f}), {-0.5f, 0.0f}, angle, 1.0f);
            before = bodies.back();
            anchor = {0.5f, 0.0f};
        }
        if (density > 0.0f)
            add(before, anchor, (count + 2.0) * along, make_circle(2.0f), {-2.0f, 0.0f}, angle, density);
    }

    void add(BodyId before, Vec2 anchor_before, DVec2 position, const Shape& shape, Vec2 anchor, double angle,
             float density) {
        BodyDef def;
        def.pose = {position, make_rotation(angle)};
        bodies.push_back(world.create_body(def));
        ShapeDef part;
        part.shape = shape;
        part.material.density = density;
        part.filter.group = -1;
        world.add_shape(bodies.back(), part);
        joints.push_back({.body_a = before, .body_b = bodies.back(), .anchor_a = anchor_before, .anchor_b = anchor});
        world.create_joint(joints.back());
    }

    DVec2 world_point(BodyId id, Vec2 anchor) const {
        const Pose pose = world.state(id).pose;
        return pose.position + DVec2(rotate(pose.rotation, anchor));
    }
    double widest_gap() const {
        double gap = 0.0;
        for (const RevoluteJointDef& joint : joints)
            gap = std::max(
                gap, length(world_point(joint.body_a, joint.anchor_a) - world_point(joint.body_b, joint.anchor_b)));
        return gap;
    }
    double energy_above_lowest() const {
        double lowest = 0.0, y = 0.0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const double half = double{joints[i].anchor_b.x};
            lowest += double{world.mass(bodies[i]).mass} * kGravity * (y + half);
            y += 2.0 * half;
        }
        return energy(world, bodies) - lowest;
    }
};

struct Course {
    double lowest = 1.0, highest = 1.0;  // energy, as a part of that at the start
    double widest_gap = 0.0;             // m
};

Course run_course(Chain& chain, int steps) {
    Course course;
    const double start = chain.energy_above_lowest();
    for (int step = 0; step < steps; ++step) {
        chain.world.step();
        const double part = chain.energy_above_lowest() / start;
        course.lowest = std::min(course.lowest, part);
        course.highest = std::max(course.highest, part);
        course.widest_gap = std::max(course.widest_gap, chain.widest_gap());
    }
    return course;
}

}  // namespace

TEST_CASE("a pendulum keeps period and amplitude for 100 swings, with each of the joint solvers") {
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct})
        for (const bool is_rod : {true, false})
            for (const double arm : {1.0, 2.0})
                for (const double degrees : {60.0, 120.0}) {
                    CAPTURE(static_cast<int>(solver));
                    CAPTURE(is_rod);
                    CAPTURE(arm);
                    CAPTURE(degrees);
                    constexpr double radius = 0.02;
                    const double amplitude = degrees * kPi / 180.0;
                    World world({.joints = solver});
                    const BodyId pivot = add_static(world, {0.0, 0.0}, make_circle(0.01f));
                    const BodyId bob = add_dynamic(world, {arm * std::sin(amplitude), -arm * std::cos(amplitude)},
                                                   make_circle(static_cast<float>(radius)), {}, amplitude);
                    const float reach = static_cast<float>(arm);
                    if (is_rod)
                        world.create_joint(DistanceJointDef{.body_a = pivot, .body_b = bob, .length = reach});
                    else
                        world.create_joint(RevoluteJointDef{.body_a = pivot, .body_b = bob, .anchor_b = {0.0f, reach}});
                    // On a hinge the ball rotates with the arm: L = I / (m d) with I = m r^2 / 2 + m d^2.
                    const double length = is_rod ? arm : arm + radius * radius / (2.0 * arm);
                    const Swing swing = measure_swing(world, bob);
                    CHECK(near(swing.period, pendulum_period(length, amplitude), relative(5e-4)));
                    CHECK(near(swing.amplitude, amplitude, relative(1e-3)));
                }
}

TEST_CASE("a direct double pendulum keeps its energy for a minute") {
    for (const double degrees : {0.0, 45.0, 90.5}) {
        CAPTURE(degrees);
        Chain chain(2, degrees * kPi / 180.0, 0.0f);
        const Course course = run_course(chain, 3600);
        CHECK(course.lowest > 0.98);
        CHECK(course.highest < 1.02);
        CHECK(course.widest_gap < 0.001);
    }
}

TEST_CASE("a direct chain carries 1000 times the mass of a link without opening") {
    Chain chain(50, -0.5 * kPi, 20.0f);
    CHECK(chain.world.mass(chain.bodies.back()).mass > 1000.0f * chain.world.mass(chain.bodies.front()).mass);
    run(chain.world, 600);
    CHECK(near(length(chain.world.state(chain.bodies.back()).pose.position), 52.0, absolute(0.01)));
    CHECK(chain.widest_gap() < 0.001);
}

TEST_CASE("a direct chain that swings with a heavy ball keeps its length and its energy") {
    for (const float density : {20.0f, 2.0f})
        for (const double angle : {0.0, -0.7}) {
            CAPTURE(density);
            CAPTURE(angle);
            Chain chain(50, angle, density);
            const Course course = run_course(chain, 900);
            CHECK(course.lowest > 0.98);
            CHECK(course.highest < 1.02);
            CHECK(course.widest_gap < 0.05);
        }
}

TEST_CASE("a direct chain that whips gains no energy") {
    // Ten light links and a ball of 1000 times their mass, which falls into the slack and jerks them about.
    Chain chain(10, 0.0, 20.0f);
    const Course course = run_course(chain, 900);
    CHECK(course.highest < 1.02);
}

TEST_CASE("a direct chain in free flight keeps its momentum and follows its parabola") {
    Chain chain(6, 0.3, 0.0f);
    chain.world.destroy_body(chain.joints.front().body_a);
    chain.world.set_velocity(chain.bodies.front(), {3.0f, 4.0f}, 5.0f);
    const auto momentum = [&] {
        DVec2 sum;
        for (const BodyId id : chain.bodies)
            sum += double{chain.world.mass(id).mass} * DVec2(chain.world.state(id).velocity);
        return sum;
    };
    const DVec2 before = momentum();
    run(chain.world, 120);
    // 6 links of 0.25 kg fall for 2 s: -10 m/s^2 * 2 s * 1.5 kg = -30 N s. Each sub-step rounds the velocities of up to
    // 24 m/s of 6 links three times by 2^-24 of them, and the limit of rotation takes a part of the start.
    CHECK(near(momentum().x, before.x, absolute(480 * 18 * 24.0 * 0.25 * 0x1p-24)));
    CHECK(near(momentum().y, before.y - 30.0, absolute(480 * 18 * 24.0 * 0.25 * 0x1p-24)));
}

// Such a hinge holds nothing: it belongs to no component.
TEST_CASE("a hinge between two static bodies does not change the motion of a free chain") {
    std::vector<BodyState> ends;
    for (const bool has_hinge : {false, true}) {
        Chain chain(6, 0.3, 0.0f);
        chain.world.destroy_body(chain.joints.front().body_a);
        chain.world.set_velocity(chain.bodies.front(), {3.0f, 4.0f}, 5.0f);
        const BodyId wall = add_static(chain.world, {50.0, 0.0}, make_box({1.0f, 1.0f}));
        const BodyId shelf = add_static(chain.world, {50.0, 1.0}, make_box({1.0f, 1.0f}));
        if (has_hinge)
            chain.world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = shelf, .anchor_a = {0.0f, 1.0f}});
        run(chain.world, 120);
        ends.push_back(chain.world.state(chain.bodies.back()));
    }
    CHECK(ends[0].pose == ends[1].pose);
    CHECK(ends[0].velocity == ends[1].velocity);
    CHECK(ends[0].angular_velocity == ends[1].angular_velocity);
}

// A plate of 30 times the mass of each of the two legs that it is welded to.
TEST_CASE("a heavy table whose joints are solved directly stands on its light legs, and falls asleep") {
    World world = direct_world();
    add_floor(world);
    const BodyId plate = add_dynamic(world, {0.0, 1.1}, make_box({3.0f, 0.2f}), {.density = 10.0f});
    for (const float x : {-1.0f, 1.0f}) {
        const BodyId leg = add_dynamic(world, {double{x}, 0.5}, make_box({0.2f, 1.0f}));
        world.create_joint(
            WeldJointDef{.body_a = leg, .body_b = plate, .anchor_a = {0.0f, 0.5f}, .anchor_b = {x, -0.1f}});
    }
    run(world, 60);
    CHECK(world.awake_bodies().empty());
    CHECK(near(world.state(plate).pose.position.y, 1.1, absolute(5e-4)));
}

TEST_CASE("doubled joints share their load, and hold") {
    World world = direct_world();
    const BodyId wall = add_static(world, {0.0, 0.0}, make_box({0.2f, 0.2f}));
    const BodyId beam = add_dynamic(world, {1.0, 0.0}, make_box({2.0f, 0.2f}));
    for (int i = 0; i < 2; ++i)
        world.create_joint(WeldJointDef{.body_a = wall, .body_b = beam, .anchor_b = {-1.0f, 0.0f}});
    world.create_joint(DistanceJointDef{
        .body_a = wall, .body_b = beam, .anchor_a = {0.0f, 1.0f}, .anchor_b = {0.0f, 0.0f}, .length = std::sqrt(2.0f)});
    run(world, 300);
    CHECK(length(world.state(beam).pose.position - DVec2{1.0, 0.0}) < 1e-4);
    CHECK(std::abs(angle(world.state(beam).pose.rotation)) < 1e-4);
}

// The body can only rotate to bring its anchors to their lines, and cannot reach them. Rotation hardly moves an anchor
// at the height of its centre: without the damping at a dead point, the impulse of such a row grows without bound.
TEST_CASE("direct joints that contradict a locked axis neither throw the body nor push without bound") {
    // A row answers to a speed with at most 1 / (2 kDeadPoint) masses of 1 kg. It corrects at 4 m/s in 1/240 s.
    constexpr float strongest = 240.0f * 4.0f / (2.0f * 0.01f);
    for (int i = 0; i <= 40; ++i) {
        World world = direct_world();
        const BodyId rail = add_static(world, {0.0, 0.0}, make_box({0.1f, 0.1f}));
        BodyDef def{.locks = {.x = true}};
        const BodyId body = world.create_body(def);
        world.add_shape(body, {make_box({1.0f, 1.0f})});
        const float height = 0.001f * static_cast<float>(i - 20);
        world.create_joint(
            WheelJointDef{.body_a = body, .body_b = rail, .anchor_a = {-0.15f, -0.16f}, .anchor_b = {-0.09f, 0.03f}});
        const JointId joint = world.create_joint(
            WheelJointDef{.body_a = rail, .body_b = body, .anchor_a = {0.2f, 0.0f}, .anchor_b = {0.05f, height}});
        run(world, 240);
        CHECK(length(world.reaction(joint).force) < strongest);
        CHECK(std::abs(world.state(body).angular_velocity) < 0.01f);
    }
}

TEST_CASE("the reaction of a direct joint is the weight that hangs on it") {
    Chain chain(3, -0.5 * kPi, 0.0f);
    const JointId top = chain.world.joints(chain.bodies.front()).front();
    run(chain.world, 60);
    double weight = 0.0;
    for (const BodyId id : chain.bodies) weight += kGravity * double{chain.world.mass(id).mass};
    CHECK(near(chain.world.reaction(top).force.y, weight, relative(1e-3)));
}

TEST_CASE("every kind of joint is solved directly, and continues with the same bits from a snapshot") {
    WorldDef def;
    def.joints = JointSolver::direct;
    World world = make_world_of_all_kinds(def);
    std::vector<std::byte> saved;
    for (int step = 0; step < 120; ++step) {
        if (step == 60) saved = world.save();
        world.step();
        world.audit();
    }
    World loaded = World::load(saved);
    run(loaded, 60);
    CHECK(loaded.state_hash() == world.state_hash());
}
