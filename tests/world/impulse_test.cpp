// The impulses that contacts report: sums over the whole step, which balance the change of momentum.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/near.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const Shape kBox = make_box({1.0f, 1.0f});
constexpr double kEpsilon = std::numeric_limits<float>::epsilon();

// m: how far the points of a recycled contact of round shapes, each fixed on its body, have come apart: a fortieth of
// 2 cm.
constexpr double kRecycled = 0.02 / 40.0;

double sum_of_normals(const World& world) {
    double sum = 0.0;
    for (const ContactPoint& point : world.contacts()) sum += double{point.normal_impulse};
    return sum;
}

// The linear and angular momentum of a body (about its centre of mass), against the impulses of a step's contacts.
struct Balance {
    DVec2 linear;           // N s
    double angular = 0.0;   // N m s
    double turnover = 0.0;  // N s: sum of all magnitudes, the scale of the rounding

    void add(DVec2 impulse, DVec2 arm) {
        linear = linear + impulse;
        angular += cross(arm, impulse);
        turnover += length(impulse);
    }
};

DVec2 impulse_on_b(const ContactPoint& point) {
    const DVec2 normal(point.normal), tangent = -perp(normal);
    return double{point.normal_impulse} * normal + double{point.tangent_impulse} * tangent;
}

DVec2 center_of(const World& world, BodyId body) {
    return transform_point(world.state(body).pose, world.mass(body).center);
}

// The farthest that the arm of a contact may have turned or shifted before an impact in a step, m. Such impulses act at
// any time of the step, at the arms that they have then.
double shift_in_step(const World& world, const std::vector<BodyId>& bodies, const std::vector<DVec2>& centers,
                     const std::vector<BodyState>& before) {
    constexpr double kReach = 0.75;  // of all shapes, m
    double farthest = 0.0, turned = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        farthest = std::max(farthest, length(center_of(world, bodies[i]) - centers[i]));
        const double turn = angle(world.state(bodies[i]).pose.rotation) - angle(before[i].pose.rotation);
        turned = std::max(turned, std::abs(std::remainder(turn, 2.0 * kPi)));
    }
    return 2.0 * (farthest + kReach * turned);
}

}  // namespace

TEST_CASE("the impulses on a box at rest are its weight times the step, for any number of sub-steps") {
    for (const int substeps : {1, 4, 10}) {
        WorldDef def;
        def.substeps = substeps;
        def.sleeping = false;
        World world(def);
        add_floor(world);
        const BodyId box = add_dynamic(world, {0.0, 0.5}, kBox);
        run(world, 120);
        const double weight = double{world.mass(box).mass} * 10.0 * double{kStep};
        CHECK(world.contacts().size() == 2);
        CHECK(near(sum_of_normals(world), weight, kFloat));
        for (const ContactPoint& point : world.contacts())
            CHECK(near(double{point.normal_impulse}, 0.5 * weight, kFloat));
    }
}

TEST_CASE("the impulse of an impact is the momentum that it stops, and of a bounce also the momentum that it returns") {
    for (const float restitution : {0.0f, 0.5f}) {
        World world;
        add_floor(world);
        const BodyId brick = add_dynamic(world, {0.0, 3.0}, make_box({1.0f, 0.5f}), {.restitution = restitution});
        double shown = 0.0;
        for (int step = 0; step < 300 && shown == 0.0; ++step) {
            world.step();
            shown = sum_of_normals(world);
        }
        // Fallen 2.75 m: it arrives with sqrt(2 g h) = 7.4 m/s. It is stopped up to a step later, in a step whose
        // gravity is stopped too: each m g dt, and the bounce returns its part.
        const double mass = double{world.mass(brick).mass}, part = 1.0 + double{restitution};
        CHECK(std::abs(shown - part * mass * std::sqrt(2.0 * 10.0 * 2.75)) < part * 2.0 * 10.0 * mass * double{kStep});
    }
}

namespace {

void check_momentum_balance(ImpactModel impacts) {
    World world({.sleeping = false, .impacts = impacts});
    add_floor(world, {.friction = 0.7f});
    add_static(world, {-6.0, 2.0}, make_box({8.0f, 0.4f}), {.friction = 0.3f}, -0.5);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 24; ++i) {
        const Shape shape = i % 3 == 0   ? make_circle(0.4f)
                            : i % 3 == 1 ? kBox
                                         : make_capsule({-0.4f, 0.0f}, {0.4f, 0.2f}, 0.2f);
        const SurfaceMaterial material{
            .density = 1.0f + static_cast<float>(i % 4), .friction = 0.6f, .restitution = i % 5 == 0 ? 0.6f : 0.0f};
        bodies.push_back(add_dynamic(world, {-7.0 + 1.3 * (i % 6), 4.0 + 1.2 * (i / 6)}, shape, material, 0.2 * i));
    }
    double largest_tangent = 0.0, largest_turn = 0.0;
    for (int step = 0; step < 240; ++step) {
        std::vector<DVec2> centers;
        std::vector<BodyState> before;
        for (const BodyId body : bodies) {
            centers.push_back(center_of(world, body));
            before.push_back(world.state(body));
        }
        world.step();
        double shift = kRecycled;
        if (impacts == ImpactModel::in_order) shift += shift_in_step(world, bodies, centers, before);
        std::vector<Balance> balances(bodies.size());
        for (const ContactPoint& point : world.contacts()) {
            largest_tangent = std::max(largest_tangent, std::abs(double{point.tangent_impulse}));
            DVec2 position = point.point;  // has moved with A
            for (std::size_t i = 0; i < bodies.size(); ++i)
                if (point.body_a == bodies[i])
                    position -= world.state(bodies[i]).pose.position - before[i].pose.position;
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                const double side = point.body_b == bodies[i] ? 1.0 : point.body_a == bodies[i] ? -1.0 : 0.0;
                if (side != 0.0) balances[i].add(side * impulse_on_b(point), position - centers[i]);
            }
        }
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const BodyMass mass = world.mass(bodies[i]);
            const BodyState after = world.state(bodies[i]);
            const DVec2 gained = double{mass.mass} * (DVec2(after.velocity) - DVec2(before[i].velocity));
            const DVec2 wanted = balances[i].linear + DVec2{0.0, -10.0 * double{mass.mass} * double{kStep}};
            const double turned =
                double{mass.inertia} * (double{after.angular_velocity} - double{before[i].angular_velocity});
            // Some 40 roundings of velocities and impulses a sub-step: in each pass, from each contact.
            const double scale = balances[i].turnover + double{mass.mass} * (1.0 + double{length(after.velocity)});
            INFO("step ", step, " body ", i);
            CHECK(length(gained - wanted) < 160.0 * kEpsilon * scale);
            CHECK(std::abs(turned - balances[i].angular) < 160.0 * kEpsilon * scale + shift * balances[i].turnover);
            largest_turn = std::max(largest_turn, std::abs(turned));
        }
    }
    CHECK(largest_tangent > 1.0);  // so that the balance includes friction
    CHECK(largest_turn > 0.5);
}

}  // namespace

TEST_CASE("in every step the change of momentum of each body is that of gravity and the reported impulses") {
    check_momentum_balance(ImpactModel::in_order);
    check_momentum_balance(ImpactModel::at_step_end);
}

TEST_CASE("the contacts of a step show all impacts of a fast ball, of shapes that are apart before and after it too") {
    constexpr double kHalf = 5.0;  // m: of the room
    const Shape wall = make_box({14.0f, 1.0f});
    int several = 0;
    for (const double speed : {5.0, 50.0, 200.0, 350.0})
        for (int start = 0; start < 20; ++start) {
            WorldDef def;
            def.gravity = {};
            World world(def);
            for (int side = 0; side < 4; ++side) {
                const double turn = 0.5 * kPi * side;
                add_static(world, (kHalf + 0.5) * DVec2{std::sin(turn), -std::cos(turn)}, wall, {.friction = 0.3f},
                           turn);
            }
            const BodyId ball =
                add_dynamic(world, {0.3, -0.2}, make_circle(0.2f), {.friction = 0.3f, .restitution = 1.0f});
            const double direction = 2.0 * kPi * (start + 0.37) / 20;
            world.set_velocity(ball, to_float(speed * DVec2{std::cos(direction), std::sin(direction)}), 0.0f);
            const double mass = double{world.mass(ball).mass};
            for (int step = 0; step < 60; ++step) {
                const DVec2 before(world.state(ball).velocity);
                world.step();
                DVec2 impulse;
                std::vector<BodyId> walls;
                for (const ContactPoint& point : world.contacts()) {
                    impulse += (point.body_b == ball ? 1.0 : -1.0) * impulse_on_b(point);
                    if (point.normal_impulse > 0.0f)
                        walls.push_back(point.body_b == ball ? point.body_a : point.body_b);
                }
                several += walls.size() > 1;
                const DVec2 gained = mass * (DVec2(world.state(ball).velocity) - before);
                INFO("speed ", speed, " start ", start, " step ", step);
                // Some 40 roundings for each sub-step and impact: a ball hits less than 2 v / 60 walls a step.
                CHECK(length(gained - impulse) < 160.0 * kEpsilon * mass * speed * (1.0 + 2.0 * speed / 60.0));
            }
        }
    CHECK(several > 10);  // walls in one step
}
