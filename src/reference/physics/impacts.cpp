// Elastic impacts: through touching bodies, in a gas, in a cradle, flat boxes, and bounce heights.
#include <algorithm>
#include <cmath>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr double kGravity = 10.0;
constexpr DVec2 kDown{0.0, -kGravity};
constexpr double kDegree = kPi / 180.0;

// ---- A ball meets one that touches a wall ----

// Everything is rotated by `tilt` about the origin; the moving ball is the last body.
Scene superball_scene(double speed, double tilt, double start_x) {
    const DVec2 along{std::cos(tilt * kDegree), std::sin(tilt * kDegree)};
    Scene scene = empty_scene({}, 0.0, 1.0);
    add(scene, fixed(box(5.0 * along, {1.0, 20.0}, tilt)));
    add(scene, disc(4.1 * along, 0.4));
    add(scene, disc(start_x * along, 0.4, speed * along));
    return scene;
}

void measure_superball(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(50, 10);
    const struct { double speed, tilt; } shots[] = {{10.0, 0.0}, {10.0, 30.0}, {30.0, 0.0}, {3.0, 70.0}};
    Chart chart{.title = "Speed back by the phase of the step: 10 m/s",
                .x_label = "phase of the step at the impact",
                .y_label = "speed back, as a part of the speed",
                .bar = within(1.0, 0.01)};
    for (const auto& shot : shots) {
        Finding finding{.condition = text("%g m/s, at %g degrees", shot.speed, shot.tilt),
                        .quantity = "speed back, as a part of the speed",
                        .unit = "",
                        .exact = 1.0,
                        .bar = within(1.0, 0.01)};
        for (const Engine engine : kEngines) {
            Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
            for (int phase = 0; phase < phases; ++phase) {
                const double part = static_cast<double>(phase) / phases;
                const auto run = start(engine, superball_scene(shot.speed, shot.tilt, -1.0 - part * shot.speed / 60.0));
                run->run_until(10.0 / shot.speed);
                const DVec2 along{std::cos(shot.tilt * kDegree), std::sin(shot.tilt * kDegree)};
                finding.add(engine, -dot(run->body(2).velocity, along) / shot.speed);
                curve.points.push_back({part, finding.values[static_cast<std::size_t>(engine)].back()});
            }
            if (row.findings.empty()) chart.curves.push_back(curve);
        }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- A gas ----

struct Gas {
    double side;    // of the box, inside, m
    double radius;  // of a disc, m
    double speed;   // of each disc, m/s
};

// Ten discs in two rows, with directions that turn by the golden angle from one to the next.
Scene gas_scene(const Gas& gas, int first_direction) {
    Scene scene = empty_scene({}, 0.0, 1.0);
    add_walls(scene, {}, gas.side);
    const double gap = 0.15 * gas.side;
    for (int i = 0; i < 10; ++i) {
        const double turn = 137.508 * kDegree * (i + 17.0 * first_direction);
        add(scene, disc({gap * (i % 5 - 2), (i < 5 ? -0.2 : 0.2) * gas.side}, gas.radius,
                        {gas.speed * std::cos(turn), gas.speed * std::sin(turn)}));
    }
    return scene;
}

void measure_gas(RowResult& row, const Effort& effort) {
    Chart chart{.title = "Energy of the gas at 15 m/s",
                .x_label = "time, s",
                .y_label = "energy, as a part of the first",
                .bar = within(1.0, 0.005)};
    for (const Gas gas :
         {Gas{20.0, 0.5, 15.0}, Gas{20.0, 0.5, 2.0}, Gas{20.0, 0.5, 60.0}, Gas{8.0, 0.25, 30.0}, Gas{4.0, 0.12, 5.0}}) {
        Finding finding{
            .condition = text("10 discs of r %g m at %g m/s in %g m, after 60 s", gas.radius, gas.speed, gas.side),
            .quantity = "energy left",
            .unit = "",
            .exact = 1.0,
            .bar = within(1.0, 0.005)};
        for (const Engine engine : kEngines)
            for (int seed = 0; seed < effort.choose(4, 1); ++seed) {
                const auto run = start(engine, gas_scene(gas, seed));
                const double energy = run->energy();
                Curve curve{.name = name_of(engine), .engine = engine, .points = {{0.0, 1.0}}};
                for (int second = 1; second <= 60; ++second) {
                    run->run_until(second);
                    curve.points.push_back({static_cast<double>(second), run->energy() / energy});
                }
                finding.add(engine, curve.points.back().y);
                if (row.findings.empty() && seed == 0) chart.curves.push_back(curve);
            }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- A cradle ----

constexpr int kCradle = 5;

void measure_row_of_balls(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(50, 10);
    for (const double speed : {5.0, 20.0}) {
        Finding finding{.condition = text("row of five, %g m/s", speed),
                        .quantity = "last ball's speed, as a part of the first's",
                        .unit = "",
                        .exact = 1.0,
                        .bar = within(1.0, 0.02)};
        for (const Engine engine : kEngines)
            for (int phase = 0; phase < phases; ++phase) {
                Scene scene = empty_scene({}, 0.0, 1.0);
                add(scene, disc({-3.0 - speed / 60.0 * phase / phases, 0.0}, 0.5, {speed, 0.0}));
                for (int i = 1; i < kCradle; ++i) add(scene, disc({static_cast<double>(i), 0.0}, 0.5));
                const auto run = start(engine, scene);
                run->run_until(10.0 / speed);
                finding.add(engine, run->body(kCradle - 1).velocity.x / speed);
            }
        row.findings.push_back(finding);
    }
}

Scene cradle_scene(double amplitude) {
    constexpr double kArm = 4.0;
    Scene scene = empty_scene(kDown, 0.0, 1.0);
    const int beam = add(scene, fixed(ghost(box({2.0, kArm}, {6.0, 0.3}))));
    for (int i = 0; i < kCradle; ++i) {
        const double angle = i == 0 ? amplitude * kDegree : 0.0;
        const int ball = add(scene, disc({i - kArm * std::sin(angle), kArm - kArm * std::cos(angle)}, 0.5));
        add_rod(scene, beam, ball, {i - 2.0, 0.0});
    }
    return scene;
}

void measure_cradle(RowResult& row, const Effort& effort) {
    measure_row_of_balls(row, effort);
    Chart chart{.title = "Energy of the hanging cradle, lifted by 40 degrees",
                .x_label = "time, s",
                .y_label = "energy, as a part of the first",
                .bar = at_least(0.95)};
    for (const double amplitude : {40.0, 20.0}) {
        Finding finding{.condition = text("hanging, lifted by %g degrees, after 10 s", amplitude),
                        .quantity = "energy left",
                        .unit = "",
                        .exact = 1.0,
                        .bar = within(1.0, 0.05)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, cradle_scene(amplitude));
            const double energy = run->energy();
            Curve curve{.name = name_of(engine), .engine = engine};
            for (int tenth = 0; tenth <= 100; ++tenth) {
                run->run_until(0.1 * tenth);
                curve.points.push_back({run->time(), run->energy() / energy});
            }
            finding.add(engine, curve.points.back().y);
            if (chart.curves.size() < 2) chart.curves.push_back(curve);
        }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- A flat box ----

void measure_flat_box(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(50, 10);
    const struct {
        DVec2 size;
        double speed;
    } boxes[] = {{{1.0, 1.0}, 10.0}, {{2.0, 0.5}, 10.0}, {{1.0, 1.0}, 2.0}, {{0.5, 2.0}, 25.0}};
    for (const auto& shot : boxes) {
        Finding spin{.condition = text("%g m x %g m at %g m/s", shot.size.x, shot.size.y, shot.speed),
                     .quantity = "spin after the bounce for each m/s",
                     .unit = "rad/m",
                     .exact = 0.0,
                     .bar = at_most(0.01)};
        Scene scene = empty_scene({}, 0.0, 1.0);
        add_floor(scene, 20.0 * phases);
        for (int phase = 0; phase < phases; ++phase) {
            const double height = 1.0 + 0.5 * shot.size.y + shot.speed / 60.0 * phase / phases;
            add(scene, box({5.0 * (phase - 0.5 * phases), height}, shot.size));
            scene.bodies.back().velocity = {0.0, -shot.speed};
        }
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            run->run_until(2.0 / shot.speed + 0.1);
            for (int phase = 0; phase < phases; ++phase)
                spin.add(engine, std::abs(run->body(phase + 1).spin) / shot.speed);
        }
        row.findings.push_back(spin);
    }
}

// ---- Bounce heights ----

// The height of the first apex after an impact: the parabola through the three highest samples.
double apex_after_bounce(EngineRun& run, int body, double radius) {
    double before = 0.0, at = run.body(body).position.y;
    bool bounced = false;
    while (run.time() < 10.0) {
        run.step();
        const double after = run.body(body).position.y;
        bounced = bounced || run.body(body).velocity.y > 0.0;
        if (bounced && at > before && at >= after) {
            const double bend = before - 2.0 * at + after, slope = 0.5 * (after - before);
            return at - (bend < 0.0 ? 0.5 * slope * slope / bend : 0.0) - radius;
        }
        before = at;
        at = after;
    }
    return std::numeric_limits<double>::infinity();
}

void measure_bounce_height(RowResult& row, const Effort& effort) {
    constexpr double kRadius = 0.5;
    const int phases = effort.choose(20, 5);
    for (const double restitution : {0.5, 0.8, 1.0}) {
        Finding finding{.condition = text("e %g", restitution),
                        .quantity = "height of the bounce, as a part of the fall",
                        .unit = "",
                        .exact = restitution * restitution,
                        .bar = within(restitution * restitution, 0.01)};
        for (const Engine engine : kEngines)
            for (int phase = 0; phase < phases; ++phase) {
                const double height = 5.0 + 0.17 * phase / phases;
                Scene scene = empty_scene(kDown, 0.0, restitution);
                add_floor(scene);
                const int ball = add(scene, disc({0.0, kRadius + height}, kRadius));
                const auto run = start(engine, scene);
                finding.add(engine, apex_after_bounce(*run, ball, kRadius) / height);
            }
        row.findings.push_back(finding);
    }
}

}  // namespace

std::vector<PhysicsRow> impact_rows() {
    return {
        {"B1", "Elastic ball against a ball at a wall",
         "Without gravity, a ball meets an equal one that touches a wall; all are elastic.",
         "The impacts follow each other: the second ball takes the speed, returns from the wall, and gives it back. "
         "The "
         "first ball leaves with the speed of its arrival.",
         "within 1 % at every phase", measure_superball},
        {"B2", "Energy of a gas", "Ten elastic discs in a closed box, without gravity and friction.",
         "Each elastic impact keeps the energy.", "within 0.005 of the energy after 60 s", measure_gas},
        {"B3", "Cradle of five touching balls",
         "A ball meets four equal elastic ones that touch in a row; and the same hung from rods of 4 m.",
         "Impacts in the order of time: the last ball takes the whole speed. Rods and elastic impacts keep the energy.",
         "speed within 2 %, energy after 10 s within 5 %", measure_cradle},
        {"B4", "Bounce of a flat box", "An elastic box lands flat on a floor, without gravity.",
         "By symmetry it leaves without spin.", "0.01 rad/s for each m/s", measure_flat_box},
        {"O6", "Bounce height", "A ball falls from 5 m or a little more.",
         "It leaves at e times its speed: it rises to e^2 of the height.", "within 0.01 of the height",
         measure_bounce_height},
    };
}

}  // namespace tumble::reference
