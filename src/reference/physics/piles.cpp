// Structures at rest: card house, pyramids, stacks.
#include <algorithm>
#include <cmath>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr DVec2 kDown{0.0, -10.0};

// ---- Card house ----

// Cards of 40 cm lean on each other at 25 degrees from upright, five pairs in the lowest storey and one in the highest,
// with flat cards over neighbouring pairs.
Scene card_house_scene(SceneRate rate, double friction, double thickness) {
    constexpr double kCard = 0.4, kLean = 25.0, kApart = 0.175;
    Scene scene = empty_scene(kDown, friction, 0.0, rate);
    scene.world.sleeping = true;
    add(scene, fixed(box({0.0, -2.0}, {80.0, 4.0})));
    const auto card = [&](DVec2 at, double angle) { add(scene, box(at, {thickness, kCard}, angle)); };
    double left = 0.0, middle = 0.18;
    for (int pairs = 5; pairs > 0; --pairs) {
        for (int pair = 0; pair < pairs; ++pair) {
            const double x = left + 2.0 * kApart * pair;
            if (pair + 1 < pairs) card({x + 0.25, middle + 0.185}, 90.0);
            card({x, middle}, -kLean);
            card({x + kApart, middle}, kLean);
        }
        left += kApart;
        middle += 0.37;
    }
    return scene;
}

double farthest_moved(const EngineRun& run, const Scene& scene) {
    double farthest = 0.0;
    for (int body = 0; body < run.body_count(); ++body)
        farthest =
            std::max(farthest, length(run.body(body).position - scene.bodies[static_cast<std::size_t>(body)].position));
    return farthest;
}

void measure_card_house(RowResult& row, const Effort& effort) {
    std::vector<SceneRate> rates = {{60.0, 4}, {120.0, 4}};
    if (!effort.is_short) rates.insert(rates.end(), {{240.0, 4}, {60.0, 8}});
    const int frictions = effort.choose(10, 1);
    for (const SceneRate rate : rates) {
        Finding moved{.condition = "40 cards of 2 mm, " + rate_text(rate) + ", 5 s" +
                                   (frictions > 1 ? std::string(", frictions of 0.7 to 0.79") : ""),
                      .quantity = "farthest moved card",
                      .unit = "m",
                      .exact = 0.0,
                      .bar = at_most(0.05)};
        for (int i = 0; i < frictions; ++i) {
            const Scene scene = card_house_scene(rate, 0.7 + 0.01 * i, 0.002);
            for (const Engine engine : kEngines) {
                const auto run = start(engine, scene);
                run->run_until(5.0);
                moved.add(engine, farthest_moved(*run, scene));
            }
        }
        row.findings.push_back(moved);
    }
}

// ---- Pyramids ----

Scene pyramid_scene(int rows) {
    Scene scene = empty_scene(kDown, 0.6, 0.0);
    scene.world.sleeping = true;
    add_floor(scene);
    for (int level = 0; level < rows; ++level)
        for (int i = 0; i < rows - level; ++i) add(scene, box({i - 0.5 * (rows - 1 - level), level + 0.5}, {1.0, 1.0}));
    return scene;
}

// The time at which all bodies sleep, or infinity after `longest` seconds. The curve gets the fastest body of each
// tenth of a second.
double time_to_sleep(EngineRun& run, double longest, Curve& curve) {
    while (run.time() < longest) {
        run.run_until(run.time() + 0.1);
        double fastest = 0.0;
        for (int body = 1; body < run.body_count(); ++body)
            fastest = std::max(fastest, length(run.body(body).velocity));
        curve.points.push_back({run.time(), fastest});
        if (run.all_asleep()) return run.time();
    }
    return std::numeric_limits<double>::infinity();
}

void measure_pyramids(RowResult& row, const Effort& effort) {
    const struct {
        int rows;
        double box2d_v3, longest;  // s: the bar, and when to give up
    } pyramids[] = {{20, 0.9, 3.0}, {40, 1.6, 4.0}, {100, 5.9, 6.0}};
    for (const auto& pyramid : pyramids) {
        if (effort.is_short && pyramid.rows > 20) continue;
        Finding sleep{.condition = text("%g rows", pyramid.rows),
                      .quantity = "all asleep after",
                      .unit = "s",
                      .bar = at_most(pyramid.box2d_v3)};
        Chart chart{.title = text("Fastest box of the pyramid of %g rows", pyramid.rows),
                    .x_label = "time, s",
                    .y_label = "speed, m/s",
                    .log_y = true};
        for (const Engine engine : kEngines) {
            const auto run = start(engine, pyramid_scene(pyramid.rows));
            Curve curve{.name = name_of(engine), .engine = engine};
            sleep.add(engine, time_to_sleep(*run, pyramid.longest, curve));
            chart.curves.push_back(curve);
        }
        row.findings.push_back(sleep);
        row.charts.push_back(chart);
    }
}

// ---- A dropped stack ----

void measure_dropped_stack(RowResult& row, const Effort& effort) {
    constexpr int kBoxes = 10;
    const int phases = effort.choose(20, 4);
    Chart chart{.title = "Fastest upward speed by the height of the fall",
                .x_label = "height, m",
                .y_label = "speed up, m/s",
                .bar = Bar{0.0, 1.0}};
    Finding rebound{.condition = text("%g boxes, %g heights of 5 to 5.17 m", kBoxes, phases),
                    .quantity = "fastest upwards",
                    .unit = "m/s",
                    .exact = 0.0,
                    .bar = at_most(1.0)};
    for (const Engine engine : kEngines) {
        Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
        for (int phase = 0; phase < phases; ++phase) {
            const double height = 5.0 + 0.17 * phase / phases;  // 0.17 m: a step at 10 m/s
            Scene scene = empty_scene(kDown, 0.6, 0.0);
            add_floor(scene);
            for (int i = 0; i < kBoxes; ++i) add(scene, box({0.0, height + 0.5 + i}, {1.0, 1.0}));
            const auto run = start(engine, scene);
            double fastest = 0.0;
            while (run->time() < 2.5) {
                run->step();
                for (int i = 1; i <= kBoxes; ++i) fastest = std::max(fastest, run->body(i).velocity.y);
            }
            rebound.add(engine, fastest);
            curve.points.push_back({height, fastest});
        }
        chart.curves.push_back(curve);
    }
    row.findings.push_back(rebound);
    row.charts.push_back(chart);
}

// ---- Stacks at rest ----

void measure_stack(RowResult& row, const Effort&) {
    constexpr int kBoxes = 20;
    Finding sag{.condition = text("%g boxes of 1 m, after 10 s", kBoxes),
                .quantity = "the top sinks by",
                .unit = "m",
                .exact = 0.0,
                .bar = at_most(0.069)};
    Scene scene = empty_scene(kDown, 0.6, 0.0);
    add_floor(scene);
    for (int i = 0; i < kBoxes; ++i) add(scene, box({0.0, i + 0.5}, {1.0, 1.0}));
    add_after(sag, scene, 10.0, [](const EngineRun& run) { return kBoxes - 0.5 - run.body(kBoxes).position.y; });
    row.findings.push_back(sag);
}

void measure_mass_ratio(RowResult& row, const Effort&) {
    constexpr int kBoxes = 10;
    Finding sunk{.condition = "1 : 400 on ten boxes, after 20 s",
                 .quantity = "the heavy box sinks by",
                 .unit = "m",
                 .exact = 0.0,
                 .bar = at_most(1.5)};
    Scene scene = empty_scene(kDown, 0.6, 0.0);
    scene.world.sleeping = true;
    scene.materials.push_back({.name = "heavy", .density = 400.0, .color = {}});
    add_floor(scene);
    for (int i = 0; i < kBoxes; ++i) add(scene, box({0.0, i + 0.5}, {1.0, 1.0}));
    const int heavy = add(scene, box({0.0, kBoxes + 0.5}, {1.0, 1.0}));
    scene.bodies.back().shapes.front().material = "heavy";
    add_after(sunk, scene, 20.0, [&](const EngineRun& run) { return kBoxes + 0.5 - run.body(heavy).position.y; });
    row.findings.push_back(sunk);
}

}  // namespace

std::vector<PhysicsRow> pile_rows() {
    return {
        {"C", "Card house",
         "Five storeys of 40 cards of 40 cm x 2 mm, held by friction of 0.7 to 0.79 (short form: 0.7).",
         "The house stands: a card at 25 degrees from upright needs at most tan 25 = 0.47 at its foot.", "under 5 cm",
         measure_card_house},
        {"H", "Pyramids fall asleep", "Pyramids of boxes of 1 m stand at the start, with sleeping on.",
         "No exact answer: the times of Box2D v3.", "0.9 s, 1.6 s and 5.9 s for 20, 40 and 100 rows", measure_pyramids},
        {"K", "Dropped stack", "Ten boxes on each other fall as one stack, restitution 0.",
         "They arrive at one speed and stop.", "under 1 m/s upwards at every phase", measure_dropped_stack},
        {"P4", "Sag of a stack", "Twenty boxes stand on each other.", "Rigid boxes do not sink.", "69 mm",
         measure_stack},
        {"P5", "Heavy box on light ones", "A box of 400 times their mass stands on ten boxes.",
         "Rigid boxes do not sink.", "it stands: less than 1.5 m of ten", measure_mass_ratio},
    };
}

}  // namespace tumble::reference
