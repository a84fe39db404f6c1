// Fast bodies: landing depth, times of bounces, paddles, rods, bullets, thin walls, leaks.
#include <algorithm>
#include <cmath>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kGolden = 137.508 * kDegree;  // successive multiples of it cover all directions evenly

double golden_part(int i) { return std::fmod(0.618034 * i, 1.0); }  // the same for parts from 0 to 1

// ---- Landing ----

void measure_landing(RowResult& row, const Effort& effort) {
    const int phases = effort.choose(100, 20);
    Chart chart{.title = "Deepest overlap at 29 m/s by the phase of the step",
                .x_label = "phase of the step at the impact",
                .y_label = "overlap, m",
                .bar = Bar{0.0, 0.01}};
    const struct {
        double radius, speed;
    } landings[] = {{0.5, 29.0}, {0.5, 20.0}, {0.5, 5.0}, {0.1, 29.0}, {2.0, 29.0}};
    for (const auto& landing : landings) {
        Scene scene = empty_scene({}, 0.0, 0.0);
        add_floor(scene, 20.0 * phases);
        for (int phase = 0; phase < phases; ++phase) {
            const double height = 1.0 + landing.speed / 60.0 * phase / phases;
            add(scene,
                disc({6.0 * (phase - 0.5 * phases), height + landing.radius}, landing.radius, {0.0, -landing.speed}));
        }
        Finding finding{.condition = text("r %g m at %g m/s", landing.radius, landing.speed),
                        .quantity = "deepest overlap",
                        .unit = "m",
                        .exact = 0.0,
                        .bar = at_most(0.01)};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            std::vector<double> deepest(static_cast<std::size_t>(phases), 0.0);
            while (run->time() < 0.2 + 2.0 / landing.speed) {
                run->step();
                for (int phase = 0; phase < phases; ++phase) {
                    double& overlap = deepest[static_cast<std::size_t>(phase)];
                    overlap = std::max(overlap, landing.radius - run->body(phase + 1).position.y);
                }
            }
            Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
            for (int phase = 0; phase < phases; ++phase) {
                const double overlap = deepest[static_cast<std::size_t>(phase)];
                finding.add(engine, overlap);
                curve.points.push_back({static_cast<double>(phase) / phases, overlap});
            }
            if (row.findings.empty()) chart.curves.push_back(curve);
        }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- A ball between two walls ----

// The time of the bounce: a ball that left a wall within the step has moved away from it at its speed since.
double time_of_bounce(const EngineRun& run, double reach) {
    const BodyMotion ball = run.body(2);
    const double wall = ball.velocity.x > 0.0 ? -reach : reach;
    return run.time() - std::abs(ball.position.x - wall) / std::abs(ball.velocity.x);
}

void measure_bounces(RowResult& row, const Effort& effort) {
    constexpr double kRadius = 0.1, kInner = 10.0, kReach = 0.5 * kInner - kRadius;
    constexpr int kBounces = 100;
    const int phases = effort.choose(10, 3);
    Chart chart{.title = "Lateness of each bounce at 200 m/s", .x_label = "bounce", .y_label = "late by, %"};
    for (const double speed : {20.0, 50.0, 200.0}) {
        Finding finding{.condition = text("%g m/s, bounce 100", speed),
                        .quantity = "late by",
                        .unit = "%",
                        .exact = 0.0,
                        .bar = within(0.0, 0.5)};
        for (const Engine engine : kEngines)
            for (int phase = 0; phase < phases; ++phase) {
                const double from = 0.0371 + speed / 60.0 * phase / phases;
                Scene scene = empty_scene({}, 0.0, 1.0);
                for (const double side : {-1.0, 1.0}) add(scene, fixed(box({side * 5.5, 0.0}, {1.0, 10.0})));
                add(scene, disc({from, 0.0}, kRadius, {speed, 0.0}));
                const auto run = start(engine, scene);
                const double first = (kReach - from) / speed, longest = 3.0 * (first + kBounces * 2.0 * kReach / speed);
                Curve curve{.name = name_of(engine), .engine = engine};
                double late = std::numeric_limits<double>::infinity(), before = speed;
                for (int bounce = 0; bounce < kBounces && run->time() < longest;) {
                    run->step();
                    const double now = run->body(2).velocity.x;
                    if (now * before < 0.0) {
                        const double exact = first + bounce * 2.0 * kReach / speed;
                        late = 100.0 * (time_of_bounce(*run, kReach) / exact - 1.0);
                        curve.points.push_back({static_cast<double>(++bounce), late});
                    }
                    before = now;
                }
                finding.add(engine, curve.points.size() == kBounces ? late : std::numeric_limits<double>::infinity());
                if (speed == 200.0 && phase == 0) chart.curves.push_back(curve);
            }
        row.findings.push_back(finding);
    }
    row.charts.push_back(chart);
}

// ---- Paddles and rods ----

// The number of balls that a paddle, or a bar, has not moved.
double count_missed(const EngineRun& run, const std::vector<int>& balls) {
    return static_cast<double>(
        std::ranges::count_if(balls, [&](int ball) { return length(run.body(ball).velocity) < 0.1; }));
}

// Sixty pairs above each other, each a part of a step later than the one below. The exact speed of a ball after an
// inelastic impact is that of the paddle.
void measure_paddles(RowResult& row, const Effort& effort) {
    const int starts = effort.choose(60, 20);
    for (const double speed : {25.0, 50.0, 100.0}) {
        Scene scene = empty_scene({}, 0.6, 0.0);
        std::vector<int> balls;
        for (int i = 0; i < starts; ++i) {
            const double y = 6.0 * (i - 0.5 * starts);
            add(scene, kinematic(box({-4.0 - speed / 60.0 * i / starts, y}, {0.2, 3.0})));
            scene.bodies.back().velocity = {speed, 0.0};
            balls.push_back(add(scene, disc({0.0, y}, 0.25)));
        }
        Finding missed = make_count(text("paddle at %g m/s, %g starts", speed, starts), "balls missed");
        add_after(missed, scene, 6.0 / speed + 0.05, [&](const EngineRun& run) { return count_missed(run, balls); });
        row.findings.push_back(missed);
    }
}

// Rods that turn about their centres, and a ball within reach of each tip's circle. A rod is beyond its ball after a
// quarter of a turn; the other tip then still has a quarter to go.
Scene rod_scene(int starts, double spin, BodyType type, std::vector<int>& balls) {
    constexpr double kLength = 10.0, kBall = 0.25, kAt = 4.8;
    Scene scene = empty_scene({}, 0.6, 0.0);
    for (int i = 0; i < starts; ++i) {
        const DVec2 middle{16.0 * (i % 10), 16.0 * (i / 10)};
        const double turn = spin / 60.0 * i / starts;  // before the ball, besides an eighth of a turn
        SceneBody rod = box(middle, {kLength, 0.2}, -45.0 - turn / kDegree);
        rod.type = type;
        rod.angular_velocity = spin / kDegree;
        add(scene, rod);
        balls.push_back(add(scene, disc(middle + DVec2{kAt, 0.0}, kBall)));
    }
    return scene;
}

void measure_rods(RowResult& row, const Effort& effort) {
    const int starts = effort.choose(50, 20);
    for (const BodyType type : {BodyType::dynamic_body, BodyType::kinematic_body})
        for (const double tip : {100.0, 190.0}) {
            const double spin = tip / 5.0;  // rad/s
            std::vector<int> balls;
            const Scene scene = rod_scene(starts, spin, type, balls);
            const std::string kind = type == BodyType::dynamic_body ? "dynamic" : "kinematic";
            Finding missed = make_count(kind + text(" rod, tip at %g m/s, %g starts", tip, starts), "balls missed");
            add_after(missed, scene, 0.5 * kPi / spin + 1.0 / 60.0,
                      [&](const EngineRun& run) { return count_missed(run, balls); });
            row.findings.push_back(missed);
        }
}

// ---- Bullets in a box ----

Scene bullet_scene(double inner, double speed) {
    constexpr int kColumns = 19, kRows = 16;
    Scene scene = empty_scene({}, 0.0, 1.0);
    add_walls(scene, {}, inner);
    for (int i = 0; i < kColumns * kRows; ++i) {
        const double turn = kGolden * i, column = i % kColumns - 9.0, level = i / kColumns - 7.5;
        add(scene,
            disc({inner / 20.0 * column, inner / 17.0 * level}, 0.1, {speed * std::cos(turn), speed * std::sin(turn)}));
        scene.bodies.back().bullet = true;
    }
    return scene;
}

void measure_bullets(RowResult& row, const Effort& effort) {
    const double most_milliseconds = effort.choose(1500, 300);  // of CPU time
    const struct { double inner, speed; } boxes[] = {{20.0, 100.0}, {10.0, 300.0}};
    for (const auto& closed : boxes) {
        Finding cost{.condition = text("304 bullets at %g m/s in %g m", closed.speed, closed.inner),
                     .quantity = "time of a step",
                     .unit = "ms",
                     .bar = at_most(5.0)};
        const Scene scene = bullet_scene(closed.inner, closed.speed);
        for (const Engine engine : kEngines) {
            const auto run = start(engine, scene);
            for (double spent = 0.0; spent < most_milliseconds && run->time() < 1.0;) {
                run->step();
                spent = run->step_milliseconds() * run->time() / run->step_duration();
            }
            cost.add(engine, run->step_milliseconds());
        }
        row.findings.push_back(cost);
    }
}

// ---- Leaks ----

void measure_leaks(RowResult& row, const Effort& effort) {
    constexpr int kSide = 10;
    constexpr double kInner = 10.0;
    const int boxes = effort.choose(8, 2);
    const double duration = effort.choose(5, 2);
    Finding leaked = make_count(text("%g balls in %g boxes, 10 Hz, one sub-step", boxes * kSide * kSide, boxes),
                                text("balls outside after %g s", duration));
    Scene scene = empty_scene({0.0, -1000.0}, 0.6, 0.0, {10.0, 1});
    std::vector<DVec2> middles;
    std::vector<int> balls;
    for (int i = 0; i < boxes; ++i) {
        const DVec2 middle{20.0 * i, 0.0};
        add_walls(scene, middle, kInner);
        for (int k = 0; k < kSide * kSide; ++k) {
            const DVec2 nudge{0.04 * (golden_part(k + 100 * i) - 0.5), 0.0};
            balls.push_back(add(scene, disc(middle + nudge + DVec2{0.9 * (k % kSide) - 4.05, 0.9 * (k / kSide) - 4.05},
                                            0.2 + 0.02 * (k % 5))));
            middles.push_back(middle);
        }
    }
    add_after(leaked, scene, duration, [&](const EngineRun& run) {
        int outside = 0;
        for (std::size_t ball = 0; ball < balls.size(); ++ball) {
            const DVec2 at = run.body(balls[ball]).position - middles[ball];
            outside += std::max(std::abs(at.x), std::abs(at.y)) > 0.5 * kInner;
        }
        return outside;
    });
    row.findings.push_back(leaked);
}

void measure_thin_wall(RowResult& row, const Effort&) {
    constexpr int kShots = 200;
    Scene scene = empty_scene({}, 0.3, 0.2);
    add(scene, fixed(box({0.0, 0.0}, {0.001, 3.0 * kShots + 40.0})));
    for (int i = 0; i < kShots; ++i) {
        const double size = 0.05 + 0.45 * golden_part(i), speed = 20.0 + 100.0 * golden_part(3 * i + 1);
        const DVec2 at{-3.0 - 2.0 * golden_part(7 * i + 2), 3.0 * (i - 0.5 * kShots)};
        add(scene, i % 2 == 0 ? disc(at, size) : box(at, {2.0 * size, size}, 360.0 * golden_part(5 * i)));
        scene.bodies.back().velocity = {speed, 0.2 * speed * (golden_part(11 * i) - 0.5)};
    }
    Finding crossed = make_count("200 discs and boxes at 20 to 120 m/s, wall of 1 mm", "bodies behind the wall");
    add_after(crossed, scene, 1.0, [](const EngineRun& run) {
        int behind = 0;
        for (int shot = 1; shot <= kShots; ++shot) behind += run.body(shot).position.x > 0.0;
        return behind;
    });
    row.findings.push_back(crossed);
}

}  // namespace

std::vector<PhysicsRow> continuous_rows() {
    return {
        {"D", "Depth of a landing", "A disc lands on a floor at many phases of the step, without gravity.",
         "Rigid bodies do not overlap.", "1 cm at every phase", measure_landing},
        {"E", "Times of elastic bounces",
         "A disc of radius 0.1 m bounces 100 times between walls 10 m apart. The time of a bounce is interpolated from "
         "the state after its step.",
         "Bounce k is at (4.9 m - x + (k - 1) 9.8 m) / v. Box2D limits a body to 2 m in a step, 120 m/s.",
         "within 0.5 % at each speed", measure_bounces},
        {"F1", "Paddle against resting balls",
         "A kinematic paddle of 0.2 m moves over the position of a resting ball of radius 0.25 m, at many phases of "
         "the "
         "step. No body is a bullet.",
         "The paddle sweeps over every ball.", "0 missed", measure_paddles},
        {"F2", "Tip of a turning rod against resting balls",
         "A rod of 10 m turns about its centre; a ball of radius 0.25 m rests 4.8 m from it. No body is a bullet.",
         "The tip sweeps over every ball within an eighth of a turn and one step.", "0 missed", measure_rods},
        {"I", "Cost of many bullets", "304 elastic bullets of radius 0.1 m fly in a closed box.",
         "No exact answer: CPU time of a step, the mean of the first second.", "5 ms", measure_bullets},
        {"N", "Leaks under extreme gravity",
         "Balls of radius 0.2 m to 0.28 m in closed boxes of 10 m fall with 1000 m/s^2, at 10 steps a second with one "
         "sub-step.",
         "No ball leaves a closed box.", "0 leaked", measure_leaks},
        {"P3", "Thin wall", "Discs and boxes of 5 cm to 1 m are shot at a static wall.", "No body crosses the wall.",
         "0 behind the wall", measure_thin_wall},
    };
}

}  // namespace tumble::reference
