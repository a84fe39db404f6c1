// Joints that contradict each other: the world stays finite, and bodies behave again once the contradiction ends.
#include <doctest/doctest.h>

#include <cmath>
#include <variant>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A body over a floor, joined to two carriers that move apart forever and rotate against each other.
struct Torn {
    World world;
    BodyId left{}, right{}, body{};

    Torn(float speed, float spin, float size, JointSolver solver = JointSolver::iterative) : world({.joints = solver}) {
        add_floor(world);
        left = add_carrier(-0.5, -speed, spin);
        right = add_carrier(0.5, speed, -spin);
        body = add_dynamic(world, {0.0, 1.0}, make_box({size, 0.5f * size}));
    }

    BodyId add_carrier(double x, float speed, float spin) {
        BodyDef def;
        def.type = BodyType::kinematic_body;
        def.pose.position = {x, 1.0};
        def.velocity = {speed, 0.0f};
        def.angular_velocity = spin;
        return world.create_body(def);
    }

    // The same kind of joint to both carriers, a little off both centres.
    template <class Def>
    void join_by(Def def) {
        for (const BodyId carrier : {left, right}) {
            def.body_a = body;
            def.body_b = carrier;
            def.anchor_a = {0.0f, 0.02f};
            def.anchor_b = {carrier == left ? 0.5f : -0.5f, 0.0f};
            world.create_joint(def);
        }
    }
};

PrismaticJointDef slider() {
    PrismaticJointDef def;
    def.limits = JointLimits{-0.1f, 0.1f};
    return def;
}

WheelJointDef strut() {
    WheelJointDef def;
    def.limits = JointLimits{-0.1f, 0.1f};
    return def;
}

DistanceJointDef rod() {
    DistanceJointDef def;
    def.length = 0.3f;
    return def;
}

}  // namespace

TEST_CASE("a body between two joints that move apart stays finite, for every kind of joint") {
    const std::vector<JointDef> kinds{slider(), strut(), rod(), RevoluteJointDef{}, WeldJointDef{}};
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct})
        for (const JointDef& kind : kinds)
            for (const float speed : {1.0f, 5.0f, 10.0f})
                for (const float spin : {0.0f, 3.0f, 6.0f})
                    for (const float size : {0.1f, 1.0f}) {
                        CAPTURE(kind.index());
                        CAPTURE(speed);
                        CAPTURE(spin);
                        CAPTURE(size);
                        Torn torn(speed, spin, size, solver);
                        std::visit(
                            [&](const auto& def) {
                                if constexpr (requires { def.anchor_a; }) torn.join_by(def);
                            },
                            kind);
                        CHECK_NOTHROW(run(torn.world, 300));
                    }
}

// Off both rails only the limits act on it, and they differ by rounding.
TEST_CASE("a slider between two contradicting limits moves no faster than its carriers") {
    for (const float speed : {1.0f, 5.0f, 10.0f}) {
        Torn torn(speed, 0.0f, 1.0f);
        torn.join_by(slider());
        for (int step = 0; step < 300; ++step) {
            torn.world.step();
            REQUIRE(length(torn.world.state(torn.body).velocity) < 1.01f * speed);
        }
    }
}

// It hangs 2 cm below the line of its carriers again; the joints yield by F / (m w^2) = 0.1 mm.
TEST_CASE("joints that were pulled apart close again once their carriers have come back") {
    const auto check = [](const auto& def, JointSolver solver) {
        CAPTURE(static_cast<int>(solver));
        Torn torn(5.0f, 0.0f, 1.0f, solver);
        torn.join_by(def);
        run(torn.world, 100);
        torn.world.set_velocity(torn.left, {5.0f, 0.0f}, 0.0f);
        torn.world.set_velocity(torn.right, {-5.0f, 0.0f}, 0.0f);
        run(torn.world, 100);
        torn.world.set_velocity(torn.left, {}, 0.0f);
        torn.world.set_velocity(torn.right, {}, 0.0f);
        run(torn.world, 200);
        CHECK(length(torn.world.state(torn.body).velocity) < 0.001f);
        CHECK(std::abs(torn.world.state(torn.body).pose.position.y - 0.98) < 0.001);
    };
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct}) {
        check(slider(), solver);
        check(WeldJointDef{}, solver);
    }
    // Hinges leave it swinging about its anchor, as nothing damps them: both solvers solve two of them directly.
}
