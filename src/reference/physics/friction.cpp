// Friction: oblique impacts, dominoes, sliding, slipping and rolling.
#include <algorithm>
#include <cmath>
#include <string>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr double kGravity = 10.0;
constexpr DVec2 kDown{0.0, -kGravity};
constexpr double kDegree = kPi / 180.0;

struct Oblique {
    double radius, along, down, restitution, friction;  // m, m/s
    SceneRate rate;
};

// Discs one after the other over a floor, each a part of a step later than the one before.
Scene oblique_scene(const Oblique& impact, int phases) {
    Scene scene = empty_scene({}, impact.friction, impact.restitution, impact.rate);
    add_floor(scene, 20.0 * phases);
    const double step = impact.down / impact.rate.steps_per_second;
    for (int phase = 0; phase < phases; ++phase)
        add(scene, disc({8.0 * (phase - 0.5 * phases), 1.0 + impact.radius + phase * step / phases}, impact.radius,
                        {impact.along, -impact.down}));
    return scene;
}

// The normal impulse J = m (1 + e) v_n slips if it cannot stop the surface: speed along - mu J / m.
void measure_oblique(RowResult& row, const Oblique& impact, double tolerance, int phases) {
    const double exact = impact.along - impact.friction * (1.0 + impact.restitution) * impact.down;
    const Scene scene = oblique_scene(impact, phases);
    Finding finding{.condition = text("r %g m, %g m/s down, %g along, mu %g, ", impact.radius, impact.down,
                                      impact.along, impact.friction) +
                                 rate_text(impact.rate),
                    .quantity = "speed along",
                    .unit = "m/s",
                    .exact = exact,
                    .bar = within(exact, tolerance)};
    Chart chart{.title = "Speed along after the impact: " + finding.condition,
                .x_label = "phase of the step at the impact",
                .y_label = "speed along, m/s",
                .bar = finding.bar};
    for (const Engine engine : kEngines) {
        const auto run = start(engine, scene);
        run->run_until(1.0);
        Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
        for (int phase = 0; phase < phases; ++phase) {
            const double speed = run->body(phase + 1).velocity.x;
            finding.add(engine, speed);
            curve.points.push_back({static_cast<double>(phase) / phases, speed});
        }
        chart.curves.push_back(curve);
    }
    if (row.charts.empty()) row.charts.push_back(chart);
    row.findings.push_back(finding);
}

void measure_inelastic_oblique(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(100, 20);
    measure_oblique(row, {0.5, 5.0, 10.0, 0.0, 0.05, {60.0, 4}}, 0.02, phases);
    measure_oblique(row, {0.5, 20.0, 10.0, 0.0, 0.3, {60.0, 4}}, 0.02, phases);
    measure_oblique(row, {0.2, 5.0, 6.0, 0.0, 0.1, {60.0, 4}}, 0.02, phases);
    measure_oblique(row, {0.5, 5.0, 10.0, 0.0, 0.05, {240.0, 4}}, 0.02, phases);
}

void measure_elastic_oblique(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(100, 20);
    measure_oblique(row, {0.5, 5.0, 10.0, 0.5, 0.1, {60.0, 4}}, 0.05, phases);
    measure_oblique(row, {0.2, 12.0, 10.0, 0.8, 0.2, {60.0, 4}}, 0.05, phases);
    measure_oblique(row, {0.5, 5.0, 10.0, 0.5, 0.1, {240.0, 4}}, 0.05, phases);
}

// ---- Dominoes ----

constexpr int kDominoes = 30;
constexpr double kDominoWidth = 0.1, kDominoHeight = 0.5, kDominoSpacing = 0.25;

// Of the dominoes' corners, m: Box2D gives polygons without rounding a skin of 1 cm, which shortens the gaps.
constexpr double kDominoRounding = 0.0003;

Scene domino_scene(SceneRate rate) {
    Scene scene = empty_scene(kDown, 0.3, 0.0, rate);
    add_floor(scene);
    for (int i = 0; i < kDominoes; ++i) {
        SceneBody domino = box({kDominoSpacing * i, 0.5 * kDominoHeight}, {kDominoWidth, kDominoHeight});
        std::get<BoxGeometry>(domino.shapes.front().geometry).radius = kDominoRounding;
        add(scene, domino);
    }
    scene.bodies[1].angular_velocity = -300.0;
    return scene;
}

// The time at which a domino has turned by 10 degrees, interpolated between two steps.
std::vector<double> topple_times(EngineRun& run) {
    constexpr double kToppled = 10.0 * kDegree;
    std::vector<double> times(kDominoes, std::numeric_limits<double>::infinity()), before(kDominoes, 0.0);
    while (run.time() < 20.0 && !std::isfinite(times.back())) {
        run.step();
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double turned = std::abs(run.body(static_cast<int>(i) + 1).angle);
            if (turned >= kToppled && !std::isfinite(times[i]))
                times[i] = run.time() - run.step_duration() * (turned - kToppled) / (turned - before[i]);
            before[i] = turned;
        }
    }
    return times;
}

void measure_dominoes(RowResult& row, const Effort& effort) {
    constexpr double kExact = 2.60;
    constexpr int kFirst = 10, kLast = 25;  // the wave is steady, and not yet at the end of the row
    std::vector<SceneRate> rates = {{60.0, 4}, {60.0, 32}, {240.0, 4}};
    if (!effort.is_short) rates.push_back({1920.0, 4});
    Chart chart{.title = "The dominoes one after the other, at 60 Hz with 4 sub-steps",
                .x_label = "time, s",
                .y_label = "domino"};
    for (const SceneRate rate : rates) {
        Finding finding{.condition = rate_text(rate),
                        .quantity = "speed of the wave",
                        .unit = "m/s",
                        .exact = kExact,
                        .bar = within(kExact, 0.02 * kExact)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, domino_scene(rate));
            const std::vector<double> times = topple_times(*run);
            finding.add(engine, kDominoSpacing * (kLast - kFirst) / (times[kLast] - times[kFirst]));
            if (row.findings.empty()) chart.curves.push_back(curve_of_indices(engine, times));
        }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- Sliding, slipping and rolling ----

void measure_slip_angle(RowResult& row, const Effort& effort) {
    const int slopes = effort.choose(41, 21);
    for (const double friction : {0.2, 0.6, 1.0}) {
        const double exact = std::atan(friction) / kDegree, step = 2.0 / (slopes - 1);
        Scene scene = empty_scene(kDown, friction, 0.0);
        std::vector<int> boxes;
        for (int i = 0; i < slopes; ++i) {
            const double tilt = exact - 1.0 + i * step, c = std::cos(tilt * kDegree), s = std::sin(tilt * kDegree);
            const DVec2 middle{60.0 * i, 0.0};
            add(scene, fixed(box(middle, {30.0, 1.0}, tilt)));
            boxes.push_back(add(scene, box(middle + 0.75 * DVec2{-s, c}, {1.0, 0.5}, tilt)));
        }
        Finding finding{.condition = text("mu %g", friction),
                        .quantity = "steepest slope without slipping",
                        .unit = "degrees",
                        .exact = exact,
                        .bar = within(exact, 0.5)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            run->run_until(3.0);
            int stuck = 0;
            while (stuck < slopes && length(run->body(boxes[static_cast<std::size_t>(stuck)]).velocity) < 0.01) ++stuck;
            finding.add(engine, exact - 1.0 + (stuck - 0.5) * step);
        }
        row.findings.push_back(finding);
    }
}

void measure_sliding_distance(RowResult& row, const Effort&) {
    for (const double speed : {2.0, 5.0, 10.0}) {
        constexpr double kFriction = 0.3;
        Scene scene = empty_scene(kDown, kFriction, 0.0);
        add_floor(scene);
        const int sliding = add(scene, box({0.0, 0.25}, {1.0, 0.5}));
        scene.bodies.back().velocity = {speed, 0.0};
        const double exact = speed * speed / (2.0 * kFriction * kGravity);
        Finding finding{.condition = text("%g m/s, mu %g", speed, kFriction),
                        .quantity = "distance",
                        .unit = "m",
                        .exact = exact,
                        .bar = within(exact, 0.01 * exact)};
        add_after(finding, scene, 1.0 + speed / (kFriction * kGravity),
                  [&](const EngineRun& run) { return run.body(sliding).position.x; });
        row.findings.push_back(finding);
    }
}

void measure_rolling(RowResult& row, const Effort&) {
    constexpr double kTime = 2.0, kRadius = 0.5;
    for (const double tilt : {10.0, 20.0, 30.0}) {
        const double c = std::cos(tilt * kDegree), s = std::sin(tilt * kDegree);
        Scene scene = empty_scene(kDown, 0.6, 0.0);
        add(scene, fixed(box({}, {60.0, 1.0}, -tilt)));
        const DVec2 from = (0.5 + kRadius) * DVec2{s, c};
        const int rolling = add(scene, disc(from, kRadius));
        const double exact = 0.5 * (2.0 / 3.0) * kGravity * s * kTime * kTime;
        Finding finding{.condition = text("%g degrees, mu 0.6, after %g s", tilt, kTime),
                        .quantity = "distance",
                        .unit = "m",
                        .exact = exact,
                        .bar = within(exact, 0.01 * exact)};
        add_after(finding, scene, kTime,
                  [&](const EngineRun& run) { return length(run.body(rolling).position - from); });
        row.findings.push_back(finding);
    }
}

void measure_seams(RowResult& row, const Effort&) {
    for (const double speed : {2.0, 10.0, 25.0}) {
        Scene scene = empty_scene(kDown, 0.0, 0.0);
        for (int tile = 0; tile < 34; ++tile) add(scene, fixed(box({tile - 5.0, -0.5}, {1.0, 1.0})));
        const int sliding = add(scene, box({0.0, 0.25}, {1.2, 0.5}));
        scene.bodies.back().velocity = {speed, 0.0};
        Finding finding{.condition = text("%g m/s over 20 seams", speed),
                        .quantity = "slowest, as a part of the speed",
                        .unit = "",
                        .exact = 1.0,
                        .bar = at_least(0.9999)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            double slowest = speed;
            while (run->body(sliding).position.x < 20.0 && run->time() < 25.0 / speed) {
                run->step();
                slowest = std::min(slowest, run->body(sliding).velocity.x);
            }
            finding.add(engine, slowest / speed);
        }
        row.findings.push_back(finding);
    }
}

}  // namespace

std::vector<PhysicsRow> friction_rows() {
    return {
        {"A1", "Friction of an oblique impact, restitution 0",
         "A disc meets a floor at an angle, without gravity, at many phases of the step.",
         "Coulomb: while it slips, the friction impulse is mu times the normal impulse m v_n, so that "
         "v = v_along - mu v_n. It slips throughout, as v exceeds the speed of rolling, v_along / 1.5.",
         "+- 0.02 m/s at every phase", measure_inelastic_oblique},
        {"A2", "Friction of an oblique bounce", "As A1, with restitution.",
         "The normal impulse is m (1 + e) v_n: v = v_along - mu (1 + e) v_n.", "+- 0.05 m/s at every phase",
         measure_elastic_oblique},
        {"A3", "Wave of dominoes",
         "Thirty boxes of 0.1 m x 0.5 m stand 0.25 m apart, friction 0.3; the first is pushed over. The speed is that "
         "between dominoes 10 and 25, by the times at which they have turned by 10 degrees.",
         "2.60 m/s: the limit of Moreau time stepping with Coulomb friction (Moreau 1988, unilateral contact and dry "
         "friction) for small steps. Impulses solved at the level of velocities to convergence give 2.596, 2.598 and "
         "2.601 at 960, 1920 and 3840 steps a second.",
         "within 2 % at each rate", measure_dominoes},
        {"O1", "Slip angle", "Boxes lie on slopes of 1 degree below to 1 degree above the slip angle.",
         "Coulomb: a box slips if tan(angle) > mu.", "+- 0.5 degrees", measure_slip_angle},
        {"O2", "Sliding distance", "A box slides over a floor until it stops.",
         "The friction force mu m g does the work m v^2 / 2: distance v^2 / (2 mu g).", "within 1 %",
         measure_sliding_distance},
        {"O3", "Disc that rolls down a slope", "A disc starts from rest on a slope on which it does not slip.",
         "Inertia m r^2 / 2: acceleration 2/3 g sin(angle), distance half of that times t^2. It rolls if "
         "tan(angle) < 3 mu.",
         "within 1 %", measure_rolling},
        {"P1", "Seams of a tiled floor", "A box slides over tiles without friction.",
         "Nothing acts along the floor: the speed stays.", "at least 0.9999 of the speed", measure_seams},
    };
}

}  // namespace tumble::reference
