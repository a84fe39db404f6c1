// A pile of ragdolls: gaps of joints at rest, and the time until all sleep.
#include <algorithm>

#include "reference/physics/row_lists.hpp"
#include "reference/physics/row_text.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

namespace {

constexpr DVec2 kDown{0.0, -10.0};

struct Part {
    DVec2 at;       // from the middle of the chest
    DVec2 half;     // of a capsule's axis; for the head and the trunk 0
    double radius;  // of a capsule or a disc
    DVec2 size;     // of a box, or 0
};

// Head, chest, hips, upper arms, forearms, thighs and shins.
constexpr Part kParts[] = {
    {{0.0, 0.55}, {}, 0.24, {}},           {{}, {}, 0.0, {0.5, 0.56}},
    {{0.0, -0.5}, {}, 0.0, {0.46, 0.4}},   {{-0.48, 0.13}, {0.2, 0.0}, 0.1, {}},
    {{0.48, 0.13}, {0.2, 0.0}, 0.1, {}},   {{-0.98, 0.13}, {0.2, 0.0}, 0.08, {}},
    {{0.98, 0.13}, {0.2, 0.0}, 0.08, {}},  {{-0.13, -0.98}, {0.0, 0.2}, 0.12, {}},
    {{0.13, -0.98}, {0.0, 0.2}, 0.12, {}}, {{-0.13, -1.56}, {0.0, 0.2}, 0.1, {}},
    {{0.13, -1.56}, {0.0, 0.2}, 0.1, {}},
};

struct PartJoint {
    int a, b;
    DVec2 at;              // from the middle of the chest
    SceneInterval limits;  // degrees
};
constexpr PartJoint kPartJoints[] = {
    {1, 0, {0.0, 0.3}, {-40.0, 40.0}},      {1, 2, {0.0, -0.3}, {-30.0, 30.0}},
    {1, 3, {-0.27, 0.13}, {-80.0, 100.0}},  {1, 4, {0.27, 0.13}, {-100.0, 80.0}},
    {3, 5, {-0.72, 0.13}, {-5.0, 140.0}},   {4, 6, {0.72, 0.13}, {-140.0, 5.0}},
    {2, 7, {-0.13, -0.73}, {-100.0, 20.0}}, {2, 8, {0.13, -0.73}, {-20.0, 100.0}},
    {7, 9, {-0.13, -1.27}, {-5.0, 130.0}},  {8, 10, {0.13, -1.27}, {-130.0, 5.0}},
};

SceneBody part_body(const Part& part, DVec2 chest) {
    if (part.size.x > 0.0) {
        SceneBody body = box(chest + part.at, part.size);
        std::get<BoxGeometry>(body.shapes.front().geometry).radius = 0.1;
        return body;
    }
    SceneBody body = disc(chest + part.at, part.radius);
    if (length_sq(part.half) > 0.0)
        body.shapes.front().geometry = CapsuleGeometry{.from = -part.half, .to = part.half, .radius = part.radius};
    return body;
}

void add_doll(Scene& scene, DVec2 chest) {
    const int first = static_cast<int>(scene.bodies.size());
    for (const Part& part : kParts) add(scene, part_body(part, chest));
    for (const PartJoint& joint : kPartJoints) {
        add_hinge(scene, first + joint.a, first + joint.b, chest + joint.at);
        scene.joints.back().limits = joint.limits;
        scene.joints.back().motor = SceneJointMotor{.speed = 0.0, .max_torque = 0.3};
    }
}

Scene doll_scene(int dolls, int columns, double drop) {
    constexpr double kApart = 8.0, kHigh = 60.0;  // m, the walls
    Scene scene = empty_scene(kDown, 0.6, 0.0);
    scene.world.sleeping = true;
    add_floor(scene);
    for (const double side : {-1.0, 1.0})
        add(scene, fixed(box({side * (0.5 * kApart + 0.5), 0.5 * kHigh}, {1.0, kHigh})));
    for (int doll = 0; doll < dolls; ++doll)
        add_doll(scene, {2.6 * (doll % columns - 0.5 * (columns - 1)), drop + 1.8 + 2.6 * (doll / columns)});
    return scene;
}

void drop_dolls(RowResult& row, int dolls, JointSolver solver) {
    const std::string condition = text("%g ragdolls, ", dolls) + name_of(solver);
    Finding gap{.condition = condition,
                .quantity = "widest gap of a joint at rest",
                .unit = "m",
                .exact = 0.0,
                .bar = at_most(0.005)};
    Finding sleep{.condition = condition, .quantity = "all asleep after", .unit = "s", .bar = at_most(4.0)};
    Chart chart{.title = "Widest gap of a joint, " + name_of(solver),
                .x_label = "time, s",
                .y_label = "gap, m",
                .log_y = true,
                .bar = Bar{1e-4, 0.005}};
    Scene scene = doll_scene(dolls, 3, 0.5);
    scene.world.joints = solver;
    for (const Engine engine : kEngines) {
        const auto run = start(engine, scene);
        Curve curve{.name = name_of(engine), .engine = engine};
        while (run->time() < 12.0 && !run->all_asleep()) {
            run->step();
            curve.points.push_back({run->time(), run->widest_gap()});
        }
        gap.add(engine, run->widest_gap());
        sleep.add(engine, run->all_asleep() ? run->time() : std::numeric_limits<double>::infinity());
        chart.curves.push_back(curve);
    }
    row.findings.push_back(gap);
    row.findings.push_back(sleep);
    row.charts.push_back(chart);
}

void measure_ragdolls(RowResult& row, const Effort& effort) {
    for (const JointSolver solver : kJointSolvers) drop_dolls(row, effort.choose(30, 9), solver);
}

}  // namespace

std::vector<PhysicsRow> ragdoll_rows() {
    return {
        {"G1", "Pile of ragdolls", "Ragdolls of 11 parts fall between walls 8 m apart.",
         "The anchors of a joint coincide: gap 0.", "5 mm at rest, asleep within 4 s", measure_ragdolls},
    };
}

}  // namespace tumble::reference
