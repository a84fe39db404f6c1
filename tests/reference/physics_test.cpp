// The rows of the page of evidence: their exact answers, their verdicts, and rows whose laws both engines follow.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "reference/physics/rows.hpp"
#include "reference/physics/scene_parts.hpp"
#include "support/near.hpp"
#include "tumble/world.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;

namespace {

RowResult measure(const char* name) {
    const PhysicsRow* row = find_physics_row(name);
    REQUIRE_MESSAGE(row, name);
    return run_row(*row, {.is_short = true});
}

const Finding& find_finding(const RowResult& result, const std::string& condition) {
    for (const Finding& finding : result.findings)
        if (finding.condition.find(condition) != std::string::npos) return finding;
    FAIL("no condition " << condition);
    return result.findings.front();
}

}  // namespace

TEST_CASE("rows have different names, texts, and measure something in both engines") {
    std::set<std::string_view> names;
    for (const PhysicsRow& row : physics_rows()) {
        CHECK(names.insert(row.name).second);
        for (const std::string_view text : {row.title, row.setup, row.formula, row.bar}) CHECK(!text.empty());
        CHECK(static_cast<bool>(row.measure));
    }
    CHECK(names.size() >= 27);
    CHECK(find_physics_row("A") == nullptr);
}

TEST_CASE("the worst value is the farthest from the exact one, and one that was not reached is worse") {
    Finding finding{.condition = "", .quantity = "", .unit = "", .exact = 4.5, .bar = within(4.5, 0.02)};
    CHECK(std::isnan(finding.worst(Engine::tumble)));
    CHECK(!finding.holds(Engine::tumble));
    for (const double value : {4.51, 4.485, 4.5}) finding.add(Engine::tumble, value);
    CHECK(finding.worst(Engine::tumble) == 4.485);
    CHECK(finding.holds(Engine::tumble));
    CHECK(!finding.holds(Engine::box2d));
    finding.add(Engine::tumble, 4.53);
    CHECK(finding.worst(Engine::tumble) == 4.53);
    CHECK(!finding.holds(Engine::tumble));
    finding.add(Engine::tumble, std::numeric_limits<double>::infinity());
    CHECK(std::isinf(finding.worst(Engine::tumble)));
    finding.add(Engine::box2d, std::numeric_limits<double>::quiet_NaN());
    CHECK(!finding.holds(Engine::box2d));
}

TEST_CASE("without an exact answer the worst value is the nearest to failing") {
    Finding most{.condition = "", .quantity = "", .unit = "", .bar = at_most(5.0)};
    Finding least{.condition = "", .quantity = "", .unit = "", .bar = at_least(0.9)};
    for (const double value : {1.0, 3.0, 2.0}) {
        most.add(Engine::tumble, value);
        least.add(Engine::tumble, value);
    }
    CHECK(most.worst(Engine::tumble) == 3.0);
    CHECK(least.worst(Engine::tumble) == 1.0);
}

TEST_CASE("a row holds if all its findings do and no engine failed") {
    RowResult result;
    CHECK(!result.holds());
    result.findings.push_back({.condition = "", .quantity = "", .unit = "", .bar = at_most(1.0)});
    result.findings.front().add(Engine::tumble, 0.5);
    result.findings.front().add(Engine::box2d, 2.0);
    CHECK(result.holds());
    result.failure = "diverged";
    CHECK(!result.holds());
}

// T = 4 int_0^a d(angle) / sqrt(2 g / l (cos(angle) - cos(a))); with sin(angle / 2) = sin(a / 2) sin(u) it is
// 4 sqrt(l / g) int_0^(pi / 2) du / sqrt(1 - sin(a / 2)^2 sin(u)^2), which the trapezium rule sums to rounding.
TEST_CASE("the exact period of a pendulum is that of the elliptic integral") {
    const RowResult result = measure("L1");
    const struct {
        const char* condition;
        double length, degrees;
    } pendulums[] = {{"arm 2 m, r 0.02 m, 120 degrees, hinge", 2.0 + 0.5 * 0.02 * 0.02 / 2.0, 120.0},
                     {"arm 2 m, r 0.02 m, 120 degrees, rod", 2.0, 120.0},
                     {"arm 1 m, r 0.3 m, 60 degrees, hinge", 1.0 + 0.5 * 0.3 * 0.3, 60.0}};
    for (const auto& pendulum : pendulums) {
        constexpr int kParts = 200;
        const double k = std::sin(0.5 * pendulum.degrees * kPi / 180.0);
        double sum = 0.0;
        for (int i = 0; i < kParts; ++i) {
            const double s = k * std::sin(0.5 * kPi * (i + 0.5) / kParts);
            sum += 1.0 / std::sqrt(1.0 - s * s);
        }
        const double period = 4.0 * std::sqrt(pendulum.length / 10.0) * 0.5 * kPi / kParts * sum;
        const Finding& finding = find_finding(result, pendulum.condition);
        REQUIRE(finding.exact);
        CHECK(near(*finding.exact, period, relative(1e-12)));
        CHECK(near(finding.bar.upper - finding.bar.lower, 0.001 * period, relative(1e-9)));
    }
}

TEST_CASE("the bars of impacts with friction are about Coulomb's speeds") {
    const RowResult plastic = measure("A1"), elastic = measure("A2");
    CHECK(*find_finding(plastic, "5 along, mu 0.05, 60 Hz").exact == 4.5);  // 5 - 0.05 x 10
    CHECK(*find_finding(elastic, "5 along, mu 0.1, 60 Hz").exact == 3.5);   // 5 - 0.1 x 1.5 x 10
    CHECK(near(find_finding(plastic, "mu 0.05, 60 Hz").bar.upper, 4.52, kDouble));
    CHECK(near(find_finding(elastic, "mu 0.1, 60 Hz").bar.lower, 3.45, kDouble));
    // Box2D solves friction after the normal impulses, and is right: the measurement is too.
    for (const RowResult* row : {&plastic, &elastic})
        for (const Finding& finding : row->findings) CHECK(finding.holds(Engine::box2d));
}

TEST_CASE("rows whose laws tumble follows hold") {
    for (const char* name : {"A1", "A2", "A3", "B1", "B2", "B3", "B4", "C",  "D",  "E",  "F1", "F2", "G3", "K",
                             "M",  "N",  "O1", "O2", "O3", "O4", "O5", "O6", "P1", "P2", "P3", "P4", "P5"}) {
        CAPTURE(name);
        CHECK(measure(name).holds());
    }
}

TEST_CASE("a state that is not finite ends a row, which does not hold") {
    const PhysicsRow row{
        .name = "X", .title = "", .setup = "", .formula = "", .bar = "", .measure = [](RowResult&, const Effort&) {
            throw SimulationDiverged({}, 3);
        }};
    const RowResult result = run_row(row, {});
    CHECK(!result.failure.empty());
    CHECK(!result.holds());
}

TEST_CASE("both engines run the same scene: energies, gaps and sleep agree at the start") {
    Scene scene = empty_scene({0.0, -10.0}, 0.5, 0.0);
    const int pivot = add(scene, fixed(ghost(disc({0.0, 4.0}, 0.1))));
    const int bar = add(scene, box({1.0, 4.0}, {2.0, 0.5}));
    scene.bodies.back().angular_velocity = 90.0;
    add_hinge(scene, pivot, bar, {0.0, 4.0});
    // Mass 1, inertia (4 + 0.25) / 12.
    const double kinetic = 0.5 * 4.25 / 12.0 * 0.25 * kPi * kPi;
    for (const Engine engine : kEngines) {
        const auto run = start(engine, scene);
        CHECK(run->body_count() == 2);
        CHECK(!run->is_dynamic(pivot));
        CHECK(near(run->mass(bar), 1.0, kFloat));
        CHECK(near(run->kinetic_energy(), kinetic, float_sum(4)));
        CHECK(near(run->potential_energy(), 40.0, float_sum(4)));
        CHECK(run->widest_gap() < 1e-6);
        CHECK(!run->all_asleep());
        run->run_until(0.5);
        CHECK(near(run->time(), 0.5, kDouble));
        CHECK(run->widest_gap() > 0.0);
    }
}
