// Free flight: parabolas, damping, rotation, and the spring.
#include <algorithm>
#include <cmath>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr double kGravity = 10.0;
constexpr DVec2 kDown{0.0, -kGravity};
constexpr double kFlight = 3.0;  // s
constexpr DVec2 kFrom{0.0, 100.0};

std::vector<SceneRate> flight_rates() { return {{30.0, 4}, {60.0, 4}, {240.0, 4}, {1920.0, 4}}; }

// v' = -g - c v: velocity (v + g / c) exp(-c t) - g / c, and its integral. c = 0 is the parabola.
DVec2 position_at(double time, DVec2 velocity, double damping) {
    if (damping == 0.0) return kFrom + time * velocity + DVec2{0.0, -0.5 * kGravity * time * time};
    const double part = -std::expm1(-damping * time) / damping, terminal = kGravity / damping;
    return kFrom + DVec2{velocity.x * part, (velocity.y + terminal) * part - terminal * time};
}

Finding measure_flight(SceneRate rate, DVec2 velocity, double damping, double tolerance) {
    Scene scene = empty_scene(kDown, 0.0, 0.0, rate);
    const int flying = add(scene, disc(kFrom, 0.5, velocity));
    scene.bodies.back().linear_damping = damping;
    const DVec2 exact = position_at(kFlight, velocity, damping);
    Finding finding{
        .condition = text("(%g, %g) m/s, damping %g /s, ", velocity.x, velocity.y, damping) + rate_text(rate),
        .quantity = "error of the position",
        .unit = "m",
        .exact = 0.0,
        .bar = at_most(tolerance)};
    for (const Engine engine : kEngines) {
        const auto run = start(engine, scene);
        run->run_until(kFlight);
        finding.add(engine, length(run->body(flying).position - exact));
    }
    return finding;
}

Chart error_chart(const std::vector<Finding>& findings, const std::vector<SceneRate>& rates) {
    Chart chart{.title = "Error after 3 s by the step rate",
                .x_label = "steps per second",
                .y_label = "error, m",
                .log_x = true,
                .log_y = true,
                .bar = findings.front().bar};
    for (const Engine engine : kEngines) {
        Curve curve{.name = name_of(engine), .engine = engine};
        for (std::size_t i = 0; i < rates.size(); ++i)
            curve.points.push_back({rates[i].steps_per_second, findings[i].worst(engine)});
        chart.curves.push_back(curve);
    }
    return chart;
}

void measure_projectile(RowResult& row, const Effort&) {
    for (const DVec2 velocity : {DVec2{10.0, 10.0}, DVec2{-25.0, 3.0}})
        for (const SceneRate rate : flight_rates()) row.findings.push_back(measure_flight(rate, velocity, 0.0, 1e-3));
    row.charts.push_back(error_chart(row.findings, flight_rates()));
}

void measure_damped_projectile(RowResult& row, const Effort&) {
    for (const double damping : {0.5, 2.0})
        for (const SceneRate rate : flight_rates())
            row.findings.push_back(measure_flight(rate, {10.0, 10.0}, damping, 1e-3));
    row.charts.push_back(error_chart(row.findings, flight_rates()));
}

void measure_rotation(RowResult& row, const Effort&) {
    constexpr double kTime = 60.0;
    for (const double spin : {0.5, 1.0, 3.0}) {
        Scene scene = empty_scene({}, 0.0, 0.0);
        const int spinning = add(scene, box({}, {1.0, 0.3}));
        scene.bodies.back().angular_velocity = spin * 180.0 / kPi;
        Finding finding{.condition = text("%g rad/s for %g s", spin, kTime),
                        .quantity = "error of the angle",
                        .unit = "rad",
                        .exact = 0.0,
                        .bar = at_most(2e-5)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            const double turned = run->body(spinning).spin * kTime;  // the spin as the engine rounds it
            run->run_until(kTime);
            finding.add(engine, std::abs(std::remainder(run->body(spinning).angle - turned, 2.0 * kPi)));
        }
        row.findings.push_back(finding);
    }
}

Scene spring_scene(double hertz) {
    Scene scene = empty_scene({}, 0.0, 0.0);
    const int wall = add(scene, fixed(ghost(disc({}, 0.1))));
    const int weight = add(scene, ghost(disc({3.5, 0.0}, 0.2)));
    add_rod(scene, wall, weight, {});
    scene.joints.back().length = 3.0;
    scene.joints.back().spring = SceneJointSpring{.hertz = hertz, .damping_ratio = 0.0};
    return scene;
}

// The mean of the periods between the first and the last of the upward crossings of the rest position.
double spring_period(EngineRun& run, int periods) {
    double first = 0.0, before = run.body(1).position.x - 3.0;
    for (int count = -1; run.time() < 100.0;) {
        run.step();
        const double after = run.body(1).position.x - 3.0;
        if (before < 0.0 && after >= 0.0) {
            const double time = crossing(run.time() - run.step_duration(), run.time(), before, after);
            if (++count == 0) first = time;
            if (count == periods) return (time - first) / periods;
        }
        before = after;
    }
    return std::numeric_limits<double>::infinity();
}

void measure_spring(RowResult& row, const Effort&) {
    for (const double hertz : {0.5, 1.0, 2.0}) {
        Finding finding{.condition = text("%g Hz", hertz),
                        .quantity = "period",
                        .unit = "s",
                        .exact = 1.0 / hertz,
                        .bar = within(1.0 / hertz, 0.01 / hertz)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, spring_scene(hertz));
            finding.add(engine, spring_period(*run, 5));
        }
        row.findings.push_back(finding);
    }
}

}  // namespace

std::vector<PhysicsRow> flight_rows() {
    return {
        {"M", "Projectile", "A disc flies for 3 s under gravity.", "The parabola x + v t + g t^2 / 2.",
         "under 1 mm at every rate", measure_projectile},
        {"O4", "Damped projectile", "As M, with linear damping c.",
         "v' = g - c v: v(t) = (v - g / c) exp(-c t) + g / c, integrated once.", "under 1 mm at every rate",
         measure_damped_projectile},
        {"O5", "Period of a spring", "A disc on an undamped spring, without gravity.",
         "1 / f: the spring of f Hz has the stiffness m (2 pi f)^2.", "within 1 %", measure_spring},
        {"P2", "Free rotation", "A box spins freely for 60 s.", "The angle is spin times time.", "2e-5 rad",
         measure_rotation},
    };
}

}  // namespace tumble::reference
