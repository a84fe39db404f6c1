// Small parts of a step: softness, rotations, ids, integration.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/id_pool.hpp"
#include "dynamics/bodies/integrate.hpp"
#include "dynamics/bodies/softness.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "dynamics/continuous/swept_pair.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("softness is the implicit damped spring") {
    // Mass 1, position error 1, at rest: the implicit step of x'' = -w^2 x - 2 zeta w x' gives
    // v = -h w^2 / (1 + 2 zeta w h + w^2 h^2).
    constexpr double h = 1.0 / 240.0, hertz = 30.0, zeta = 10.0, w = 2.0 * kPi * hertz;
    const Softness soft = make_softness(static_cast<float>(hertz), static_cast<float>(zeta), static_cast<float>(h));
    const double v = -static_cast<double>(soft.mass_scale * soft.bias_rate);
    CHECK(near(v, -h * w * w / (1.0 + 2.0 * zeta * w * h + w * w * h * h), kFloat));
    CHECK(near(soft.mass_scale + soft.impulse_scale, 1.0, kFloat));
}

TEST_CASE("the frequency of softness is limited by the sub-step") {
    CHECK(near(contact_softness({}, 1.0f / 60.0f).bias_rate,
               double{make_softness(10.65f, 8.0f, 1.0f / 60.0f).bias_rate}, kFloat));
    CHECK(joint_softness({}, 1.0f / 60.0f).bias_rate == make_softness(15.0f, 2.0f, 1.0f / 60.0f).bias_rate);
}

TEST_CASE("a small rotation has unit length and the given angle") {
    for (const double wanted : {1e-6, 0.01, -0.05, 0.2}) {
        const Rotation q = small_rotation(static_cast<float>(wanted));
        CHECK(std::abs(double{q.c} * q.c + double{q.s} * q.s - 1.0) < 2e-7);
        const double series_error = std::pow(std::abs(wanted), 5) / 120.0;
        CHECK(std::abs(angle(q) - wanted) <= series_error + 1.5e-7 * std::abs(wanted));
    }
}

TEST_CASE("the speculative distance and the margin of a box grow with the body up to a limit") {
    const Tuning tuning;
    CHECK(near(tuning.speculative_distance(0.02f), 0.002, kFloat));  // a 2 cm ball must not touch at a 2 cm gap
    CHECK(tuning.speculative_distance(5.0f) == 0.02f);
    CHECK(near(tuning.aabb_margin(0.08f), 0.01, kFloat));
    CHECK(tuning.aabb_margin(5.0f) == 0.05f);
}

TEST_CASE("a contact begins at no less than the gap that gravity closes in a step, up to the limit") {
    const Tuning tuning = make_tuning(1.0f, {0.0f, -10.0f}, 1.0f / 60.0f);
    CHECK(near(tuning.contact_distance(0.002f), 10.0 / 3600.0, kFloat));
    CHECK(near(tuning.contact_distance(0.1f), 0.01, kFloat));
    CHECK(make_tuning(1.0f, {0.0f, -10.0f}, 0.1f).contact_distance(0.002f) == 0.02f);
    CHECK(near(make_tuning(0.1f, {6.0f, -8.0f}, 0.1f).contact_distance(1e-4f), 0.002, kFloat));
}

TEST_CASE("an id pool uses an index again only when it is recycled") {
    IdPool<BodyId> pool;
    const BodyId first = pool.acquire(), second = pool.acquire();
    CHECK(pool.is_live(first));
    CHECK_FALSE(pool.was_live(first));
    CHECK_FALSE(pool.is_live({first.index, first.generation + 1}));
    CHECK_FALSE(pool.is_live({2, 0}));
    pool.release(first);
    CHECK_FALSE(pool.is_live(first));
    CHECK(pool.was_live(first));
    CHECK_FALSE(pool.is_live(pool.at(first.index)));  // the next owner
    const BodyId third = pool.acquire();
    CHECK(third.index == 2);
    pool.recycle(first.index);
    const BodyId fourth = pool.acquire();
    CHECK(fourth.index == first.index);
    CHECK(fourth.generation == first.generation + 1);
    CHECK(pool.is_live(fourth));
    CHECK(pool.is_sound());
    CHECK_FALSE(pool.is_live(first));
    CHECK(std::vector<BodyId>(pool.live().begin(), pool.live().end()) == std::vector<BodyId>{fourth, second, third});
}

TEST_CASE("an inset below the rounding of a huge shape takes nothing off") {
    // 1 - 2e-4 m / 1e5 m is 1 in floats. The box of 100 km crosses the 1 m to the small box in a quarter of its motion.
    // Distances of these sizes are known to 32 u (71 km + 50 km) = 4e-10 m (MovingCores), fractions of 4 m to 1e-10.
    const auto record = [](const Shape& shape, float extent) {
        ShapeRecord made;
        made.shape = shape;
        made.smaller_extent = extent;
        return made;
    };
    const ShapeRecord huge = record(make_box({1e5f, 1e5f}), 1e5f), small = record(make_box({1.0f, 1.0f}), 1.0f);
    Sweep moving, still;
    moving.end = {4.0, 0.0};
    still.start = still.end = {50001.5, 0.0};
    const PairImpact found = find_impact(huge, moving, small, still, 1e-4f, false);
    CHECK(near(found.fraction, 0.25, absolute(4e-10)));
}

TEST_CASE("two segments without thickness have an impact") {
    ShapeRecord falling, floor;
    falling.shape = make_segment({-1.0f, 0.0f}, {1.0f, 0.0f});
    floor.shape = make_segment({-2.0f, 0.0f}, {2.0f, 0.0f});
    Sweep moving;
    moving.start = {0.0, 1.0};
    moving.end = {0.0, -3.0};
    CHECK(near(find_impact(falling, moving, floor, {}, 0.0f, false).fraction, 0.25, absolute(1e-3)));
}

namespace {

// A body that is the same for the same number: some are kinematic, locked, damped, pushed, or faster than the limits.
void add_random_body(BodyStore& bodies, unsigned number) {
    std::mt19937 random(number);
    const auto value = [&](float size) { return size * (static_cast<float>(random() % 2001) / 1000.0f - 1.0f); };
    BodyDef def;
    def.type = random() % 32 == 0 ? BodyType::kinematic_body : BodyType::dynamic_body;
    def.allow_fast_rotation = random() % 8 == 0;
    def.locks = {random() % 64 == 0, random() % 64 == 0, random() % 64 == 0};
    def.linear_damping = random() % 2 == 0 ? 0.3f : 0.0f;
    def.angular_damping = random() % 2 == 0 ? 0.7f : 0.0f;
    def.velocity = {value(10.0f), value(random() % 32 == 0 ? 1000.0f : 10.0f)};
    def.angular_velocity = value(random() % 32 == 0 ? 2000.0f : 10.0f);
    const BodyMass mass = def.type == BodyType::dynamic_body ? BodyMass{2.0f, {}, 3.0f} : BodyMass{};
    bodies.set_mass(bodies.create(def), mass, 1.0f, 1.0f);
    bodies.moving.back().acceleration = {value(5.0f), value(5.0f)};
    bodies.moving.back().angular_acceleration = value(5.0f);
}

void integrate(BodyStore& bodies) {
    constexpr SpeedLimits limits{400.0f, 47.0f, 750.0f};
    const BodyRange all{1, bodies.solver_bodies.size()};
    Crew crew;
    for (int i = 0; i < 5; ++i) {
        integrate_velocities(bodies, all, {0.5f, -9.8f}, 1.0f / 240.0f, limits, crew);
        integrate_positions(bodies, all, 1.0f / 240.0f, limits, crew);
    }
}

}  // namespace

TEST_CASE("eight bodies in lanes move as each of them does alone") {
    constexpr unsigned kBodies = 403;  // no multiple of eight
    using Bits = std::array<std::uint32_t, sizeof(SolverBody) / sizeof(std::uint32_t)>;
    BodyStore together;
    for (unsigned i = 0; i < kBodies; ++i) add_random_body(together, i);
    integrate(together);
    int clamped = 0;
    for (unsigned i = 0; i < kBodies; ++i) {
        BodyStore alone;
        add_random_body(alone, i);
        integrate(alone);
        REQUIRE(alone.solver_bodies.size() == 2);
        CHECK(std::bit_cast<Bits>(together.solver_bodies[1 + i]) == std::bit_cast<Bits>(alone.solver_bodies[1]));
        clamped += (alone.solver_bodies[1].flags & kClampedBody) != 0;
    }
    CHECK(clamped > 5);
    CHECK(clamped < 200);
}
