// Revolute joints in lanes get the bits of joints that are solved one after the other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "dynamics/joint_store/revolute_block.hpp"
#include "dynamics/joint_store/revolute_lanes.hpp"
#include "support/random_numbers.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// What a test varies.
struct Sizes {
    std::size_t bodies = 0, joints = 0;
    float reach = 0.5f;        // of the anchors, m
    float turn = 0.01f;        // of a body in a sub-step, rad
    float odd_joints = 0.1f;   // part that no lanes can solve
    std::size_t clusters = 1;  // of bodies: joints do not connect them, if there are no static bodies
    float immovable = 0.1f;    // part of the bodies
};

// The bodies, and joints between any two of them: with any parts of a drive, in and out of their limits.
struct Hinges {
    Hinges(const Sizes& sizes, unsigned seed) : random(seed) {
        for (std::size_t i = 0; i < sizes.bodies; ++i) add_body(sizes);
        for (std::size_t i = 0; i < sizes.joints; ++i) add_joint(sizes);
        order.find(joints.size(), bodies, [&](std::size_t i) {
            JoinedBodies joined;
            joined.add(ends[i].first);
            joined.add(ends[i].second);
            return joined;
        });
        lanes.find(order, entries, joints, bodies);
    }

    void add_body(const Sizes& sizes) {
        BodyDef def;
        if (random.chance(sizes.immovable))
            def.type = random.chance(0.5f) ? BodyType::static_body : BodyType::kinematic_body;
        def.pose = {DVec2(random.vector(2.0f)), make_rotation(random.between(-3.0f, 3.0f))};
        def.velocity = random.vector(3.0f);
        def.angular_velocity = random.between(-3.0f, 3.0f);
        ids.push_back(bodies.create(def));
        if (def.type == BodyType::dynamic_body)
            bodies.set_mass(ids.back(), BodyMass{random.between(0.5f, 2.0f), {}, random.between(0.1f, 2.0f)}, 1.0f,
                            1.0f);
    }

    void add_joint(const Sizes& sizes) {
        RevoluteJointDef def;
        const std::size_t count = ids.size() / sizes.clusters;
        const std::size_t first = joints.size() * sizes.clusters / sizes.joints * count;
        def.body_a = ids[first + random.below(count)];
        do {
            def.body_b = ids[first + random.below(count)];
        } while (def.body_b == def.body_a ||
                 (!bodies.is_dynamic(def.body_a.index) && !bodies.is_dynamic(def.body_b.index)));
        def.anchor_a = random.vector(sizes.reach);
        def.anchor_b = random.vector(sizes.reach);
        def.reference_angle = random.between(-1.0f, 1.0f);
        if (random.chance(0.5f)) def.spring = JointSpring{random.between(1.0f, 20.0f), random.between(0.0f, 1.0f)};
        if (random.chance(0.5f)) def.motor = AngularMotor{random.between(-5.0f, 5.0f), random.between(0.0f, 100.0f)};
        if (random.chance(0.5f)) {
            def.limits = JointLimits{random.between(-2.0f, 0.0f), 0.0f};
            def.limits->upper = def.limits->lower + random.between(0.0f, 2.0f);
        }
        entries.push_back({static_cast<std::uint32_t>(joints.size()), !random.chance(sizes.odd_joints)});
        ends.push_back({def.body_a, def.body_b});
        joints.emplace_back(def);
        joints.back().prepare(bodies);
        joints.back().update_rows(bodies.solver_bodies);
    }

    // The order of solving one joint after the other.
    template <class Visitor>
    void for_each_in_list(Visitor&& visit) {
        order.for_each_color([&](std::span<const std::uint32_t> color) {
            for (const std::uint32_t block : color)
                for (std::size_t i = order.first(block); i < order.first(block + 1); ++i) visit(joints[i]);
        });
    }

    void move(const Sizes& sizes) {
        for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
            SolverBody& body = bodies.solver_bodies[i];
            body.delta_position += random.vector(0.01f);
            body.delta_rotation = compose(make_rotation(random.between(-sizes.turn, sizes.turn)), body.delta_rotation);
        }
    }

    RandomNumbers random;
    BodyStore bodies;
    std::vector<BodyId> ids;
    std::vector<std::pair<BodyId, BodyId>> ends;
    std::vector<RevoluteJoint> joints;
    std::vector<RevoluteLanes::Entry> entries;
    JointBlocks order;
    RevoluteLanes lanes;
    Crew crew;
};

constexpr float kSubstep = 1.0f / 240.0f;

void solve_one_by_one(Hinges& hinges, const Sizes& sizes, const JointContext& context) {
    const std::span<SolverBody> bodies = hinges.bodies.solver_bodies;
    for (int i = 0; i < 4; ++i) {
        hinges.for_each_in_list([&](RevoluteJoint& joint) { joint.warm_start(bodies); });
        hinges.for_each_in_list([&](RevoluteJoint& joint) { joint.solve(context, true, bodies); });
        hinges.move(sizes);
        hinges.for_each_in_list([&](RevoluteJoint& joint) {
            joint.update_rows(bodies);
            joint.solve(context, false, bodies);
        });
    }
}

void solve_in_lanes(Hinges& hinges, const Sizes& sizes, const JointContext& context) {
    const std::span<SolverBody> bodies = hinges.bodies.solver_bodies;
    const auto for_each = [&](auto&& solve_block, auto&& solve_one) {
        RevoluteLanes::for_each(hinges.lanes, hinges.crew, solve_block,
                                [&](std::uint32_t i) { solve_one(hinges.joints[i]); });
    };
    hinges.lanes.load(hinges.joints, hinges.bodies, context.h, hinges.crew);
    for (int i = 0; i < 4; ++i) {
        for_each([&](RevoluteBlock& block) { warm_start_joints(block, bodies); },
                 [&](RevoluteJoint& joint) { joint.warm_start(bodies); });
        for_each([&](RevoluteBlock& block) { solve_joints(block, context, true, bodies); },
                 [&](RevoluteJoint& joint) { joint.solve(context, true, bodies); });
        hinges.move(sizes);
        for_each([&](RevoluteBlock& block) { solve_joints(block, context, false, bodies); },
                 [&](RevoluteJoint& joint) {
                     joint.update_rows(bodies);
                     joint.solve(context, false, bodies);
                 });
    }
    hinges.lanes.store(hinges.joints, hinges.crew);
}

// Equal numbers: 0 and -0 are.
bool are_equal(const SolverBody& a, const SolverBody& b) {
    return a.velocity == b.velocity && a.angular_velocity == b.angular_velocity;
}

std::size_t solve_both(const Sizes& sizes, unsigned seed) {
    Hinges one_by_one(sizes, seed), in_lanes(sizes, seed);
    std::size_t in_lanes_count = 0;
    for (std::size_t i = 0; i < sizes.joints; ++i) in_lanes_count += in_lanes.lanes.is_in_lanes(i);
    CHECK(in_lanes_count > sizes.joints / 6);
    const JointContext context{kSubstep, 1.0f / kSubstep, make_softness(30.0f, 1.0f, kSubstep)};
    solve_one_by_one(one_by_one, sizes, context);
    solve_in_lanes(in_lanes, sizes, context);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < one_by_one.bodies.solver_bodies.size(); ++i) {
        CAPTURE(i);
        REQUIRE(are_equal(one_by_one.bodies.solver_bodies[i], in_lanes.bodies.solver_bodies[i]));
        moved += one_by_one.bodies.solver_bodies[i].velocity != Vec2{};
    }
    for (std::size_t i = 0; i < one_by_one.joints.size(); ++i) {
        CAPTURE(i);
        const JointReaction one = one_by_one.joints[i].reaction(240.0f), lane = in_lanes.joints[i].reaction(240.0f);
        REQUIRE(one.force == lane.force);
        REQUIRE(one.torque == lane.torque);
    }
    return moved;
}

}  // namespace

TEST_CASE("joints in lanes move the bodies as joints one after the other do") {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        CHECK(solve_both({.bodies = 300, .joints = 200}, seed) > 100);
        CHECK(solve_both({.bodies = 60, .joints = 400}, seed) > 40);
        CHECK(solve_both({.bodies = 3000, .joints = 2500}, seed) > 2000);
    }
}

// Eleven blocks of one colour, which are solved three at a time.
TEST_CASE("joints in lanes of several blocks that have no body in common") {
    const Sizes sizes{.bodies = 6600, .joints = 11 * kJointsPerBlock, .clusters = 11, .immovable = 0.0f};
    for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(seed);
        const Hinges hinges(sizes, seed);
        std::vector<std::size_t> colors;
        hinges.order.for_each_color([&](std::span<const std::uint32_t> color) { colors.push_back(color.size()); });
        CHECK(colors == std::vector<std::size_t>{11});
        CHECK(solve_both(sizes, seed) > 5000);
    }
}

TEST_CASE("joints in lanes whose bodies turn by far in a step") {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        CHECK(solve_both({.bodies = 300, .joints = 200, .turn = 1.0f}, seed) > 100);
    }
}

TEST_CASE("joints in lanes that are torn so far apart that their matrix is singular") {
    const Sizes sizes{.bodies = 300, .joints = 200, .reach = 3000.0f, .odd_joints = 0.0f};
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        CHECK(solve_both(sizes, seed) > 100);
    }
}

TEST_CASE("an order without joints that fit into lanes has no lanes") {
    const Hinges hinges({.bodies = 20, .joints = 10, .odd_joints = 1.1f}, 1);
    CHECK_FALSE(hinges.lanes.is_used());
    const Hinges none({.bodies = 20, .joints = 0}, 1);
    CHECK_FALSE(none.lanes.is_used());
}
