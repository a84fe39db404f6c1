// Which groups of joints the direct solver takes in a world that iterates its joints. A group that it takes moves bit
// for bit as in a world that solves all joints directly.
#include <doctest/doctest.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kSecond = 60;  // steps

// Bars of 1 m on hinges, level or hanging, that do not touch each other: the first hinge is at the origin.
struct Bars {
    World world;
    BodyId support;
    std::vector<BodyId> bars;
    std::vector<JointId> joints;

    Bars(JointSolver solver, int count, BodyType support_type = BodyType::static_body, bool is_level = true)
        : world({.sleeping = false, .joints = solver}) {
        BodyDef def;
        def.type = support_type;
        support = world.create_body(def);
        if (support_type == BodyType::dynamic_body) world.add_shape(support, part());
        for (int i = 0; i < count; ++i) {
            const BodyId before = bars.empty() ? support : bars.back();
            BodyDef bar;
            bar.pose.position = is_level ? DVec2{i + 0.5, 0.0} : DVec2{0.0, -i - 0.5};
            bar.pose.rotation = is_level ? Rotation{} : Rotation{0.0f, -1.0f};
            bars.push_back(world.create_body(bar));
            world.add_shape(bars.back(), part());
            joints.push_back(world.create_joint(RevoluteJointDef{.body_a = before,
                                                                 .body_b = bars.back(),
                                                                 .anchor_a = i == 0 ? Vec2{} : Vec2{0.5f, 0.0f},
                                                                 .anchor_b = {-0.5f, 0.0f}}));
        }
    }

    static ShapeDef part() {
        ShapeDef shape;
        shape.shape = make_box({1.0f, 0.1f});
        shape.filter.group = -1;
        return shape;
    }

    // m
    double widest_gap() const {
        double gap = 0.0;
        for (const JointId joint : joints) {
            const auto& def = std::get<RevoluteJointDef>(world.joint(joint));
            const Pose a = world.state(def.body_a).pose, b = world.state(def.body_b).pose;
            gap = std::max(gap, length(a.position + DVec2(rotate(a.rotation, def.anchor_a)) - b.position -
                                       DVec2(rotate(b.rotation, def.anchor_b))));
        }
        return gap;
    }

    // Gives the last bar a mass, as a multiple of that of the first one.
    void weigh_down(float ratio) { world.set_mass(bars.back(), heavy_mass(ratio)); }

    BodyMass heavy_mass(float ratio) const {
        BodyMass mass = world.mass(bars.front());
        mass.mass *= ratio;
        mass.inertia *= ratio;
        return mass;
    }
};

bool is_equal(const Bars& a, const Bars& b) {
    for (std::size_t i = 0; i < a.bars.size(); ++i) {
        const BodyState left = a.world.state(a.bars[i]), right = b.world.state(b.bars[i]);
        if (left.pose.position != right.pose.position || left.velocity != right.velocity) return false;
    }
    return true;
}

// True if the bars of both move alike for a second.
bool moves_alike(Bars& a, Bars& b) {
    run(a.world, kSecond);
    run(b.world, kSecond);
    return is_equal(a, b);
}

}  // namespace

TEST_CASE("two to four joints that hang from a static body are solved directly, five are iterated") {
    for (int count = 2; count <= 5; ++count) {
        CAPTURE(count);
        Bars bars(JointSolver::iterative, count), direct(JointSolver::direct, count);
        CHECK(moves_alike(bars, direct) == (count <= 4));
    }
}

TEST_CASE("two joints that hang from a kinematic body are solved directly, those of free bodies are iterated") {
    for (const BodyType type : {BodyType::dynamic_body, BodyType::kinematic_body}) {
        Bars bars(JointSolver::iterative, 2, type), direct(JointSolver::direct, 2, type);
        bars.world.set_velocity(bars.bars[0], {0.0f, 1.0f}, 3.0f);
        direct.world.set_velocity(direct.bars[0], {0.0f, 1.0f}, 3.0f);
        CHECK(moves_alike(bars, direct) == (type == BodyType::kinematic_body));
    }
}

TEST_CASE("joints of bodies of very different masses are iterated") {
    for (const float ratio : {100.0f, 101.0f}) {
        CAPTURE(ratio);
        Bars bars(JointSolver::iterative, 3), direct(JointSolver::direct, 3);
        bars.weigh_down(ratio);
        direct.weigh_down(ratio);
        CHECK(moves_alike(bars, direct) == (ratio <= 100.0f));
    }
}

TEST_CASE("a mechanism with a motor or a limit is iterated, also if it gets one later") {
    const auto check = [](auto&& change) {
        Bars bars(JointSolver::iterative, 3), direct(JointSolver::direct, 3);
        for (Bars* one : {&bars, &direct}) {
            one->world.step();
            auto def = std::get<RevoluteJointDef>(one->world.joint(one->joints[2]));
            change(def);
            one->world.set_joint(one->joints[2], def);
        }
        return moves_alike(bars, direct);
    };
    CHECK(check([](RevoluteJointDef&) {}));
    CHECK_FALSE(check([](RevoluteJointDef& def) { def.limits = JointLimits{-3.0f, 3.0f}; }));
    CHECK_FALSE(check([](RevoluteJointDef& def) { def.motor = AngularMotor{1.0f, 1.0f}; }));
}

// Joints of bars that hang at rest open by rounding alone if they are solved directly, and by at least g / w^2 = 0.07
// mm if they are iterated, w = 2 pi 60 rad/s.
constexpr double kOpen = 5e-5;  // m

TEST_CASE("a change of masses, types or joints changes which joints are solved directly") {
    Bars bars(JointSolver::iterative, 5, BodyType::static_body, false);
    const auto gap_at_rest = [&] {
        run(bars.world, 5 * kSecond);
        return bars.widest_gap();
    };
    bars.world.set_type(bars.bars[1], BodyType::static_body);  // two joints hang from the support, three from this bar
    CHECK(gap_at_rest() < kOpen);
    bars.world.set_type(bars.bars[1], BodyType::dynamic_body);
    CHECK(gap_at_rest() > kOpen);
    bars.world.destroy_joint(bars.joints[4]);
    bars.joints.pop_back();
    CHECK(gap_at_rest() < kOpen);
    bars.weigh_down(1000.0f);  // a bar that no longer hangs there
    CHECK(gap_at_rest() < kOpen);
    bars.world.set_mass(bars.bars[3], bars.heavy_mass(1000.0f));
    CHECK(gap_at_rest() > kOpen);
}

TEST_CASE("a group is iterated while something touches one of its bodies") {
    Bars bars(JointSolver::iterative, 2);
    // It presses on the bar near the hinge, where the bar falls more slowly than a free body.
    const BodyId crate = add_dynamic(bars.world, {0.25, 0.3}, make_box({0.5f, 0.5f}));
    double touching = 0.0;
    for (int step = 0; step < 10; ++step) {
        bars.world.step();
        REQUIRE(touches(bars.world, bars.bars[0], crate));
        touching = std::max(touching, bars.widest_gap());
    }
    CHECK(touching > kOpen);
    bars.world.destroy_body(crate);
    run(bars.world, kSecond);
    CHECK(bars.widest_gap() < kOpen);
}

TEST_CASE("a saved world continues with the same joints solved directly") {
    Bars bars(JointSolver::iterative, 2);
    run(bars.world, kSecond);
    World loaded = World::load(bars.world.save());
    run(bars.world, kSecond);
    run(loaded, kSecond);
    for (const BodyId bar : bars.bars) CHECK(loaded.state(bar).pose.position == bars.world.state(bar).pose.position);
}
