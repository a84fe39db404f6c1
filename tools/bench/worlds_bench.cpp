#include "tools/bench/worlds_bench.hpp"

#include <algorithm>
#include <vector>

#include "tools/measure/median.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tumble/world.hpp"

namespace tumble::tools {

namespace {

constexpr int kStepsOfTurn = 10;  // steps before the other side has its turn

// A pyramid of ten boxes that fall a little, by another height in each world. They do not sleep.
World make_small_world(int number) {
    World world(WorldDef{.sleeping = false});
    const BodyId floor = world.create_body({.type = BodyType::static_body, .pose = {{0.0, -0.5}, {}}});
    world.add_shape(floor, {.shape = make_box({20.0f, 1.0f})});
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4 - row; ++column) {
            const double x = column - 0.5 * (3 - row), y = 0.6 + 0.01 * (number % 50) + 1.05 * row;
            const BodyId box = world.create_body({.pose = {{1.05 * x, y}, {}}});
            world.add_shape(box, {.shape = make_box({1.0f, 1.0f})});
        }
    return world;
}

struct ManyWorlds {
    explicit ManyWorlds(int count) {
        for (int i = 0; i < count; ++i) worlds.push_back(make_small_world(i));
        for (World& world : worlds) pointers.push_back(&world);
    }

    double time_steps(int count, const Threads& threads) {
        const Stopwatch watch;
        for (int i = 0; i < count; ++i) step_all(pointers, threads);
        return watch.seconds();
    }

    std::vector<World> worlds;
    std::vector<World*> pointers;
};

}  // namespace

WorldsBenchResult bench_worlds(const WorldsBenchOptions& options) {
    std::vector<double> serial, parallel;  // steps of a world per second, of each run
    for (int run = 0; run < options.runs; ++run) {
        ManyWorlds one(options.worlds), several(options.worlds);
        double one_seconds = 0.0, several_seconds = 0.0;
        for (int done = 0; done < options.steps; done += kStepsOfTurn) {
            const int count = std::min(kStepsOfTurn, options.steps - done);
            one_seconds += one.time_steps(count, {.count = 1});
            several_seconds += several.time_steps(count, {.count = options.threads});
        }
        const double steps = static_cast<double>(options.steps) * options.worlds;
        serial.push_back(steps / one_seconds);
        parallel.push_back(steps / several_seconds);
    }
    return {median(serial), median(parallel)};
}

}  // namespace tumble::tools
