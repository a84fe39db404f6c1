#include "tools/bench/growth_bench.hpp"

#include <vector>

#include "tools/measure/median.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/temporary_folder.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

constexpr int kStepsBefore = 20, kTimedSteps = 20;
constexpr int kFrameWidth = 1280, kFrameHeight = 720;
constexpr int kRows = 9;
constexpr int kColumns = 111;     // on one part of the floor: with it 1000 bodies
constexpr double kPitch = 1.1;    // of columns, m
constexpr double kRainGap = 0.3;  // m

std::string grid(int columns, int rows, double x_spacing, double y_spacing) {
    return R"("repeat": {"grid": {"columns": )" + std::to_string(columns) + R"(, "rows": )" + std::to_string(rows) +
           R"(, "spacing": [)" + std::to_string(x_spacing) + ", " + std::to_string(y_spacing) + "]}}";
}

std::string body(double x, double y, double width, const std::string& members) {
    return R"({"position": [)" + std::to_string(x) + ", " + std::to_string(y) + R"(], "shapes": [{"box": {"size": [)" +
           std::to_string(width) + R"(, 1]}}], )" + members + "}";
}

// The bodies of a city that are awake stand on the floor in one column of each part.
std::string bodies_of(GrowthWorld world, int parts) {
    const double width = kPitch * kColumns;
    const std::string floor =
        body(0.5 * (width - kPitch), -0.5, width, R"("type": "static", )" + grid(parts, 1, width, 0.0));
    switch (world) {
        case GrowthWorld::pile: return floor + ",\n" + body(0.0, 0.5, 1.0, grid(parts * kColumns, kRows, kPitch, 1.0));
        case GrowthWorld::rain:
            return floor + ",\n" +
                   body(0.0, 0.5 + kRainGap, 1.0, grid(parts * kColumns, kRows, kPitch, 1.0 + kRainGap));
        case GrowthWorld::city: break;
    }
    std::string bodies = floor;
    for (int part = 0; part < parts; ++part) {
        bodies += ",\n" + body(part * width, 0.5, 1.0, R"("awake": false, )" + grid(kColumns - 1, kRows, kPitch, 1.0));
        bodies +=
            ",\n" + body((part + 1) * width - kPitch, 0.5, 1.0, R"("allow_sleep": false, )" + grid(1, kRows, 0.0, 1.0));
    }
    return bodies;
}

std::string growth_scene(GrowthWorld world, int bodies) {
    const std::string sleeping = world == GrowthWorld::city ? "true" : "false";
    return R"({"format": 1, "name": "growth", "world": {"sleeping": )" + sleeping + R"(}, "bodies": [)" +
           bodies_of(world, bodies / kSmallestGrowth) + "]}";
}

struct GrowthTimes {
    std::vector<double> load, build, steps, frame;  // s, of each run
};

// The second frame: the first one loads the font.
double time_frame(const Scene& scene, const SceneRun& run) {
    const TemporaryFolder folder("bench");
    Renderer renderer(kFrameWidth, kFrameHeight);
    Image image;
    const Camera camera = make_camera(scene, run.built(), static_cast<double>(kFrameWidth) / kFrameHeight);
    renderer.draw(scene, run.built(), camera, run.time(), image);
    const Stopwatch watch;
    renderer.draw(scene, run.built(), camera, run.time(), image);
    write_png(image, folder.path() / "frame.png");
    return watch.seconds();
}

void time_run(const std::string& text, const GrowthOptions& options, GrowthTimes& times, GrowthResult& result) {
    const Stopwatch loading;
    const Scene scene = parse_scene(text, "growth.json");
    times.load.push_back(loading.seconds());
    const Stopwatch building;
    SceneRun run(scene);
    times.build.push_back(building.seconds());
    run.set_threads({.count = options.threads});
    for (int i = 0; i < kStepsBefore; ++i) run.world().step();
    const Stopwatch stepping;
    for (int i = 0; i < kTimedSteps; ++i) run.world().step();
    times.steps.push_back(stepping.seconds() / kTimedSteps);
    times.frame.push_back(time_frame(scene, run));
    const StepCounters counters = run.world().counters();
    result.bodies = counters.bodies;
    result.awake = counters.awake_bodies;
    result.bytes = static_cast<double>(run.world().memory().total()) / counters.bodies;
}

}  // namespace

GrowthResult bench_growth(const GrowthName& world, int bodies, const GrowthOptions& options) {
    GrowthResult result{.world = world.name};
    GrowthTimes times;
    const std::string text = growth_scene(world.world, bodies);
    for (int run = 0; run < options.runs; ++run) time_run(text, options, times, result);
    result.load_us = 1e6 * median(times.load) / bodies;
    result.build_us = 1e6 * median(times.build) / bodies;
    result.step_us = 1e6 * median(times.steps) / bodies;
    result.frame_ms = 1e3 * median(times.frame);
    return result;
}

std::vector<int> growth_sizes(int most) {
    std::vector<int> sizes;
    for (int bodies = kSmallestGrowth; bodies <= most; bodies *= 10) sizes.push_back(bodies);
    return sizes;
}

}  // namespace tumble::tools
