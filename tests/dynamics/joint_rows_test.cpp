// The rows of joints follow the bodies: the relaxing pass solves them at the poses to which the bodies have moved.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dynamics/joint_store/joint_store.hpp"
#include "support/random_numbers.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kSamples = 200;

// Three dynamic bodies at random poses.
struct Bodies {
    explicit Bodies(RandomNumbers& random) {
        for (BodyId& id : ids) {
            BodyDef def;
            def.pose = {DVec2(random.vector(2.0f)), make_rotation(random.between(-3.0f, 3.0f))};
            id = store.create(def);
            store.set_mass(id, BodyMass{random.between(0.5f, 2.0f), {}, random.between(0.5f, 2.0f)}, 1.0f, 1.0f);
        }
    }

    // As if sub-steps had passed.
    void move(RandomNumbers& random) {
        for (std::size_t i = 1; i < store.solver_bodies.size(); ++i) {
            SolverBody& body = store.solver_bodies[i];
            body.velocity = random.vector(1.0f);
            body.angular_velocity = random.between(-1.0f, 1.0f);
            body.delta_position = random.vector(0.2f);
            body.delta_rotation = make_rotation(random.between(-0.5f, 0.5f));
        }
    }

    BodyStore store;
    BodyId ids[3];
};

// The largest velocity along an equality constraint of the joint, which computes its rows at the present deltas.
template <class Joint>
float largest_velocity(Joint& joint, const BodyStore& bodies) {
    float largest = 0.0f;
    joint.visit_equalities(bodies.solver_bodies, [&](const EqualityRow& row) {
        float velocity = 0.0f;
        for (std::uint32_t i = 0; i < row.end_count; ++i) {
            const SolverBody& body = bodies.solver_bodies[row.ends[i].body];
            velocity += dot(row.ends[i].axis, body.velocity) + row.ends[i].angular * body.angular_velocity;
        }
        largest = std::max(largest, std::abs(velocity));
    });
    return largest;
}

// make(bodies, random) returns a joint, make_judge(bodies, random) one with the same constraints that lists them.
template <class Make, class MakeJudge>
void check_relaxing(const std::string& kind, Make&& make, MakeJudge&& make_judge) {
    CAPTURE(kind);
    const float h = 1.0f / 240.0f;
    const JointContext context{h, 1.0f / h, make_softness(30.0f, 1.0f, h)};
    int stale = 0;
    for (unsigned seed = 1; seed <= kSamples; ++seed) {
        CAPTURE(seed);
        const auto velocity_left = [&](bool updates) {
            RandomNumbers random(seed);
            Bodies bodies(random);
            RandomNumbers same = random;
            auto joint = make(bodies, random);
            auto judge = make_judge(bodies, same);
            joint.prepare(bodies.store);
            judge.prepare(bodies.store);
            joint.update_rows(bodies.store.solver_bodies);
            bodies.move(random);
            if (updates) joint.update_rows(bodies.store.solver_bodies);
            for (int i = 0; i < 200; ++i) joint.solve(context, false, bodies.store.solver_bodies);
            return largest_velocity(judge, bodies.store);
        };
        CHECK(velocity_left(true) < 1e-4f);
        stale += velocity_left(false) > 1e-2f;
    }
    CHECK(stale > kSamples / 2);
}

template <class Make>
void check_relaxing(const std::string& kind, Make&& make) {
    check_relaxing(kind, make, make);
}

// A definition between the first two bodies, with random anchors.
template <class Def>
Def joined(const Bodies& bodies, RandomNumbers& random) {
    Def def;
    def.body_a = bodies.ids[0];
    def.body_b = bodies.ids[1];
    def.anchor_a = random.vector(0.5f);
    def.anchor_b = random.vector(0.5f);
    return def;
}

}  // namespace

TEST_CASE("the relaxing pass solves the rows at the poses to which the bodies have moved") {
    check_relaxing("revolute", [](const Bodies& bodies, RandomNumbers& random) {
        return RevoluteJoint(joined<RevoluteJointDef>(bodies, random));
    });
    check_relaxing("weld", [](const Bodies& bodies, RandomNumbers& random) {
        return WeldJoint(joined<WeldJointDef>(bodies, random));
    });
    check_relaxing("distance", [](const Bodies& bodies, RandomNumbers& random) {
        return DistanceJoint(joined<DistanceJointDef>(bodies, random));
    });
    const auto make_slider = [](const Bodies& bodies, RandomNumbers& random) {
        auto def = joined<PrismaticJointDef>(bodies, random);
        def.axis_a = {1.0f, random.between(-1.0f, 1.0f)};
        return def;
    };
    check_relaxing("prismatic", [&](const Bodies& bodies, RandomNumbers& random) {
        return PrismaticJoint(make_slider(bodies, random));
    });
    check_relaxing("wheel", [](const Bodies& bodies, RandomNumbers& random) {
        auto def = joined<WheelJointDef>(bodies, random);
        def.axis_a = {1.0f, random.between(-1.0f, 1.0f)};
        return WheelJoint(def);
    });
    check_relaxing("pulley", [](const Bodies& bodies, RandomNumbers& random) {
        auto def = joined<PulleyJointDef>(bodies, random);
        def.ground_anchor_a = DVec2(random.vector(3.0f));
        def.ground_anchor_b = DVec2(random.vector(3.0f));
        return PulleyJoint(def);
    });
    check_relaxing("gear", [&](const Bodies& bodies, RandomNumbers& random) {
        PrismaticJointDef slider = make_slider(bodies, random);
        slider.body_b = bodies.ids[2];
        GearJointDef def;
        def.ratio = random.between(0.5f, 2.0f);
        return GearJoint(def, slider, joined<RevoluteJointDef>(bodies, random));
    });
    check_relaxing(
        "motor",
        [](const Bodies& bodies, RandomNumbers& random) {
            auto def = joined<MotorJointDef>(bodies, random);
            def.max_force = def.max_torque = std::numeric_limits<float>::max();
            return MotorJoint(def);
        },
        [](const Bodies& bodies, RandomNumbers& random) { return WeldJoint(joined<WeldJointDef>(bodies, random)); });
}
