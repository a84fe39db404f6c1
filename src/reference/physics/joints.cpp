// Joints: heavy chains, pendulums.
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

// ---- A chain with a heavy ball ----

constexpr int kLinks = 50;
constexpr double kBallRadius = 2.0, kReach = kLinks + kBallRadius;  // m, from the pivot to the ball's centre

// Links of 1 m from the origin at an angle from straight down (degrees), and a ball of 1005 times their mass. Nothing
// collides.
Scene chain_scene(double angle, JointSolver solver) {
    const DVec2 along{std::sin(angle * kDegree), -std::cos(angle * kDegree)};
    Scene scene = empty_scene(kDown, 0.6, 0.0);
    scene.world.joints = solver;
    scene.materials.push_back({.name = "heavy", .density = 20.0, .color = {}});
    int previous = add(scene, fixed(ghost(disc({}, 0.05))));
    for (int link = 0; link < kLinks; ++link) {
        const int next = add(scene, ghost(box((link + 0.5) * along, {0.25, 1.0}, angle)));
        add_hinge(scene, previous, next, static_cast<double>(link) * along);
        previous = next;
    }
    SceneBody ball = ghost(disc(kReach * along, kBallRadius));
    ball.shapes.front().material = "heavy";
    const int last = add(scene, ball);
    add_hinge(scene, previous, last, static_cast<double>(kLinks) * along);
    return scene;
}

// The chain bounces on its joints: the mean of the second half is that of its rest.
void hang_chain(RowResult& row, const Effort& effort, JointSolver solver, Bar bar) {
    const double duration = effort.choose(20, 10);
    Finding finding{.condition = text("hanging, mean of the second half of %g s, ", duration) + name_of(solver),
                    .quantity = "reach",
                    .unit = "m",
                    .exact = kReach,
                    .bar = bar};
    Chart chart{.title = "Reach of the hanging chain, " + name_of(solver),
                .x_label = "time, s",
                .y_label = "reach, m",
                .bar = Bar{kReach, bar.upper}};
    for (const Engine engine : kEngines) {
        const auto run = start(engine, chain_scene(0.0, solver));
        Curve curve{.name = name_of(engine), .engine = engine};
        double sum = 0.0;
        int count = 0;
        while (run->time() < duration) {
            run->step();
            curve.points.push_back({run->time(), length(run->body(kLinks + 1).position)});
            if (run->time() < 0.5 * duration) continue;
            sum += curve.points.back().y;
            ++count;
        }
        finding.add(engine, sum / count);
        chart.curves.push_back(curve);
    }
    row.findings.push_back(finding);
    row.charts.push_back(chart);
}

void measure_hanging_chain(RowResult& row, const Effort& effort) {
    hang_chain(row, effort, JointSolver::direct, at_most(kReach + 0.1));
    hang_chain(row, effort, JointSolver::iterative, at_most(55.55));
}

void measure_swinging_chain(RowResult& row, const Effort& effort) {
    const double duration = effort.choose(15, 5);
    Chart chart{.title = "Energy of the chain that swings from level, above its lowest point",
                .x_label = "time, s",
                .y_label = "energy, as a part of the first",
                .bar = within(1.0, 0.02)};
    for (const double angle : {90.0, 60.0}) {
        const std::string condition = text("from %g degrees, %g s", angle, duration);
        Finding gap{.condition = condition,
                    .quantity = "widest gap of a joint",
                    .unit = "m",
                    .exact = 0.0,
                    .bar = at_most(0.05)};
        Finding energy{.condition = condition,
                       .quantity = "energy above the lowest point, at its worst",
                       .unit = "",
                       .exact = 1.0,
                       .bar = within(1.0, 0.02)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, chain_scene(angle, JointSolver::direct));
            // Straight down, every body is as low as it is far from the pivot.
            double lowest = 0.0;
            for (int body = 1; body <= kLinks + 1; ++body)
                lowest -= run->mass(body) * kGravity * length(run->body(body).position);
            const double first = run->energy() - lowest;
            Curve curve{.name = name_of(engine), .engine = engine};
            double widest = 0.0, worst = 1.0;
            while (run->time() < duration) {
                run->step();
                widest = std::max(widest, run->widest_gap());
                const double left = (run->energy() - lowest) / first;
                if (std::abs(left - 1.0) > std::abs(worst - 1.0)) worst = left;
                curve.points.push_back({run->time(), left});
            }
            gap.add(engine, widest);
            energy.add(engine, worst);
            if (row.findings.empty()) chart.curves.push_back(curve);
        }
        row.findings.push_back(gap);
        row.findings.push_back(energy);
    }
    row.charts.push_back(chart);
}

// ---- Pendulums ----

// The arithmetic-geometric mean.
double agm(double a, double b) {
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

struct Pendulum {
    double arm, radius, amplitude;  // m, m, degrees
    bool hinged;                    // by a hinge, so that the ball turns with the arm, or on a rod

    // Of the simple pendulum that swings as this one: I / (m arm) with I = m (arm^2 + r^2 / 2) about the hinge.
    double length() const { return arm + (hinged ? 0.5 * radius * radius / arm : 0.0); }

    // 4 sqrt(l / g) K(sin(amplitude / 2)) with K(k) = pi / (2 agm(1, sqrt(1 - k^2))).
    double period() const {
        return 2.0 * kPi * std::sqrt(length() / kGravity) / agm(1.0, std::cos(0.5 * amplitude * kDegree));
    }
};

Scene pendulum_scene(const Pendulum& pendulum, JointSolver solver) {
    Scene scene = empty_scene(kDown, 0.0, 0.0);
    scene.world.joints = solver;
    const double angle = pendulum.amplitude * kDegree;
    const int pivot = add(scene, fixed(ghost(disc({}, 0.05))));
    const int ball = add(scene, ghost(disc(pendulum.arm * DVec2{std::sin(angle), -std::cos(angle)}, pendulum.radius)));
    if (pendulum.hinged)
        add_hinge(scene, pivot, ball, {});
    else
        add_rod(scene, pivot, ball, {});
    return scene;
}

struct Swings {
    double period = std::numeric_limits<double>::infinity();     // s, the mean
    double amplitude = std::numeric_limits<double>::infinity();  // rad, the last
    std::vector<DVec2> amplitudes{};                             // (number of the swing, rad)
};

// The largest of three neighbouring samples' parabola, the middle one being the largest.
double peak(double before, double at, double after) {
    const double bend = before - 2.0 * at + after, slope = 0.5 * (after - before);
    return bend < 0.0 ? at - 0.5 * slope * slope / bend : at;
}

Swings watch_swings(EngineRun& run, int periods, double longest) {
    Swings swings;
    const auto angle_now = [&] {
        const DVec2 at = run.body(1).position;
        return std::atan2(at.x, -at.y);
    };
    double first = 0.0, earlier = 0.0, before = angle_now();
    for (int count = -1; run.time() < longest;) {
        run.step();
        const double now = angle_now();
        if (before > earlier && before >= now && before > 0.0) {
            swings.amplitude = peak(earlier, before, now);
            swings.amplitudes.push_back({static_cast<double>(count + 1), swings.amplitude});
        }
        if (before < 0.0 && now >= 0.0 && now - before < kPi) {
            const double time = crossing(run.time() - run.step_duration(), run.time(), before, now);
            if (++count == 0) first = time;
            if (count > 0) swings.period = (time - first) / count;
            if (count == periods) return swings;
        }
        earlier = before;
        before = now;
    }
    swings.period = std::numeric_limits<double>::infinity();
    return swings;
}

void swing_pendulum(RowResult& row, Chart& chart, const Pendulum& pendulum, JointSolver solver, int periods) {
    const double exact = pendulum.period();
    const std::string condition =
        text("arm %g m, r %g m, %g degrees, ", pendulum.arm, pendulum.radius, pendulum.amplitude) +
        (pendulum.hinged ? "hinge, " : "rod, ") + name_of(solver);
    Finding period{.condition = condition,
                   .quantity = text("period, mean of %g", periods),
                   .unit = "s",
                   .exact = exact,
                   .bar = within(exact, 0.0005 * exact)};
    Finding amplitude{
        .condition = condition, .quantity = "amplitude left", .unit = "", .exact = 1.0, .bar = within(1.0, 0.001)};
    for (const Engine engine : kEngines) {
        const auto run = start(engine, pendulum_scene(pendulum, solver));
        const Swings swings = watch_swings(*run, periods, 1.5 * (periods + 2) * exact);
        period.add(engine, swings.period);
        amplitude.add(engine, swings.amplitude / (pendulum.amplitude * kDegree));
        if (!row.findings.empty()) continue;
        chart.curves.push_back({.name = name_of(engine), .engine = engine});
        for (const DVec2 point : swings.amplitudes) chart.curves.back().points.push_back({point.x, point.y / kDegree});
    }
    row.findings.push_back(period);
    row.findings.push_back(amplitude);
}

void measure_pendulum(RowResult& row, const Effort& effort) {
    const int periods = effort.choose(100, 20);
    const Pendulum pendulums[] = {{2.0, 0.02, 120.0, true}, {2.0, 0.02, 60.0, true},   {1.0, 0.02, 120.0, true},
                                  {1.0, 0.02, 60.0, true},  {2.0, 0.02, 120.0, false}, {1.0, 0.3, 60.0, true}};
    Chart chart{.title = "Amplitude of the pendulum of 2 m that starts at 120 degrees, " + name_of(kJointSolvers[0]),
                .x_label = "swing",
                .y_label = "amplitude, degrees"};
    for (const JointSolver solver : kJointSolvers)
        for (const Pendulum& pendulum : pendulums) swing_pendulum(row, chart, pendulum, solver, periods);
    row.charts.push_back(chart);
}

// Two bars of 1 m, hinged at their ends, from the origin.
Scene double_pendulum_scene(double first, double second, JointSolver solver) {
    constexpr double kThickness = 0.1;
    const DVec2 along_a{std::sin(first * kDegree), -std::cos(first * kDegree)};
    const DVec2 along_b{std::sin(second * kDegree), -std::cos(second * kDegree)};
    Scene scene = empty_scene(kDown, 0.0, 0.0);
    scene.world.joints = solver;
    const int pivot = add(scene, fixed(ghost(disc({}, 0.05))));
    const int upper = add(scene, ghost(box(0.5 * along_a, {kThickness, 1.0}, first)));
    const int lower = add(scene, ghost(box(along_a + 0.5 * along_b, {kThickness, 1.0}, second)));
    add_hinge(scene, pivot, upper, {});
    add_hinge(scene, upper, lower, along_a);
    return scene;
}

struct DoubleStart {
    double first, second;  // angles of the bars from straight down, degrees
};

void swing_double_pendulum(RowResult& row, Chart& chart, const DoubleStart& angles, JointSolver solver,
                           double duration) {
    Finding finding{.condition = text("from %g and %g degrees, after %g s, ", angles.first, angles.second, duration) +
                                 name_of(solver),
                    .quantity = "energy above the lowest point",
                    .unit = "",
                    .exact = 1.0,
                    .bar = within(1.0, 0.02)};
    for (const Engine engine : kEngines) {
        const auto run = start(engine, double_pendulum_scene(angles.first, angles.second, solver));
        // The centres of the bars hang 0.5 m and 1.5 m below the pivot at the lowest.
        const double lowest = -kGravity * (0.5 * run->mass(1) + 1.5 * run->mass(2));
        const double first = run->energy() - lowest;
        Curve curve{.name = name_of(engine), .engine = engine};
        while (run->time() < duration) {
            run->step();
            curve.points.push_back({run->time(), (run->energy() - lowest) / first});
        }
        finding.add(engine, curve.points.back().y);
        if (row.findings.empty()) chart.curves.push_back(curve);
    }
    row.findings.push_back(finding);
}

void measure_double_pendulum(RowResult& row, const Effort& effort) {
    const double duration = effort.choose(60, 20);
    Chart chart{.title = "Energy of the double pendulum that starts level, " + name_of(kJointSolvers[0]),
                .x_label = "time, s",
                .y_label = "energy, as a part of the first",
                .bar = within(1.0, 0.02)};
    const DoubleStart starts[] = {{90.0, 90.0}, {120.0, 60.0}, {60.0, 150.0}, {45.0, 45.0}};
    for (const JointSolver solver : kJointSolvers)
        for (const DoubleStart& angles : starts) swing_double_pendulum(row, chart, angles, solver, duration);
    row.charts.push_back(chart);
}

}  // namespace

std::vector<PhysicsRow> joint_rows() {
    return {
        {"G2", "Hanging chain with a heavy ball",
         "Fifty links of 1 m and a ball of 2 m radius and 1005 times the mass of a link hang straight down.",
         "Rigid links: 50 m, and 2 m to the centre of the ball.",
         "at most 52.1 m with direct joints, 55.55 m with those of the default", measure_hanging_chain},
        {"G3", "Swinging chain with a heavy ball",
         "The chain of G2 starts at rest at an angle from straight down, and swings. The joints are direct.",
         "Joints do no work: energy above the lowest point stays, gaps are 0.",
         "gaps under 5 cm, energy within 2 % at all times", measure_swinging_chain},
        {"L1", "Pendulum",
         "A disc swings from a fixed point, on a hinge or on a rod, with each of the two joint solvers.",
         "T = 4 sqrt(l / g) K(sin(a / 2)), K by the arithmetic-geometric mean (Abramowitz and Stegun, 17.6), "
         "l = arm + r^2 / (2 arm) on a hinge. The amplitude stays.",
         "period within 0.05 %, amplitude within 0.001", measure_pendulum},
        {"L2", "Double pendulum",
         "Two bars of 1 m, hinged at their ends, swing from a fixed point, with each of the two joint solvers.",
         "Energy above the lowest point stays.", "within 2 %", measure_double_pendulum},
    };
}

}  // namespace tumble::reference
