// `tumble bench`: times narrow-phase queries and the world step of tumble and of Box2D in one run.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/box2d_v3/v3_queries.hpp"
#include "tools/bench/bench_page.hpp"
#include "tools/bench/growth_bench.hpp"
#include "tools/bench/query_bench.hpp"
#include "tools/bench/step_bench.hpp"
#include "tools/bench/worlds_bench.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/machine/engines.hpp"
#include "tools/machine/machine.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/step_stages.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/data_paths.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

struct BenchArguments {
    std::vector<std::string> scenes = {"large_pyramid", "pyramid", "mixed_rain", "capsule_pile"};
    StepBenchOptions steps;
    QueryBenchOptions queries;
    WorldsBenchOptions worlds;
    int most_bodies = 0;  // of the growth; 0: not measured
    std::string v3_program;
    std::string report;
    bool force = false;
};

// The columns of Box2D v3: its time and its ratio to that of tumble. Empty if nothing times it.
std::string v3_columns(double of_v3, double of_tumble, bool has_v3) {
    if (!has_v3) return "\n";
    if (of_v3 == 0.0) return "            -       -\n";
    char text[64];
    std::snprintf(text, sizeof text, " %12.4g %7.2f\n", of_v3, of_v3 / of_tumble);
    return text;
}

std::string v3_header(const char* unit, bool has_v3) {
    return has_v3 ? std::string("        v3 ") + unit + "   ratio" : "";
}

void write_row(const QueryBenchResult& row) {
    char line[160];
    std::snprintf(line, sizeof line, "%-26s %12.1f %12.1f %7.2f", row.name.c_str(), row.tumble_ns, row.box2d_ns,
                  row.ratio());
    write_output(line + v3_columns(row.box2d_v3_ns, row.tumble_ns, reference::has_box2d_v3()));
}

void write_row(JsonWriter& json, const QueryBenchResult& row) {
    json.open_object()
        .member("case", row.name)
        .member("tumble_ns", row.tumble_ns)
        .member("box2d_ns", row.box2d_ns)
        .member("ratio", row.ratio());
    if (row.box2d_v3_ns > 0.0)
        json.member("box2d_v3_ns", row.box2d_v3_ns).member("ratio_v3", row.box2d_v3_ns / row.tumble_ns);
    json.close_object();
}

void write_row(const StepBenchResult& row, bool has_v3) {
    char line[160], box2d[64] = "            -       -";
    if (row.box2d_ms > 0.0) std::snprintf(box2d, sizeof box2d, " %12.4f %7.2f", row.box2d_ms, row.ratio());
    std::snprintf(line, sizeof line, "%-20s %7zu %9d %12.4f%s", row.scene.c_str(), row.bodies, row.contacts,
                  row.tumble_ms, box2d);
    write_output(line + v3_columns(row.box2d_v3_ms, row.tumble_ms, has_v3));
}

void write_row(JsonWriter& json, const StepBenchResult& row) {
    json.open_object()
        .member("scene", row.scene)
        .member("bodies", row.bodies)
        .member("contacts", row.contacts)
        .member("tumble_ms", row.tumble_ms);
    if (row.box2d_ms > 0.0) json.member("box2d_ms", row.box2d_ms).member("ratio", row.ratio());
    if (row.box2d_v3_ms > 0.0)
        json.member("box2d_v3_ms", row.box2d_v3_ms).member("ratio_v3", row.box2d_v3_ms / row.tumble_ms);
    json.key("stages").open_object();
    for (const StepStage& stage : kStepStages) json.member(stage.name, row.stages.*stage.ms);
    json.close_object().close_object();
}

void bench_all_queries(const Command& command, const QueryBenchOptions& options, JsonWriter& json,
                       BenchResult& result) {
    if (options.pairs == 0) return;
    if (!command.json)
        write_output("query                         tumble ns     box2d ns   ratio" +
                     v3_header("ns", reference::has_box2d_v3()) + "   (CPU time per query)\n");
    for (const reference::QueryCase& query_case : reference::query_cases()) {
        const QueryBenchResult row = bench_queries(query_case, options);
        result.queries.push_back(row);
        write_row(json, row);
        if (!command.json) write_row(row);
    }
}

void bench_all_scenes(const Command& command, const std::vector<Scene>& scenes, JsonWriter& json, BenchResult& result) {
    const StepBenchOptions& options = result.options;
    const bool has_v3 = options.v3_program || reference::has_box2d_v3();
    if (!command.json)
        write_output("scene                 bodies  contacts    tumble ms     box2d ms   ratio" +
                     v3_header("ms", has_v3) + "   (" +
                     std::string(options.uses_wall_clock() ? "wall clock" : "CPU time") + " per step)\n");
    for (const Scene& scene : scenes) {
        narrate_progress("measuring " + scene.name + "\n");
        const StepBenchResult row = bench_steps(scene, options);
        result.steps.push_back(row);
        write_row(json, row);
        if (!command.json) write_row(row, has_v3);
    }
}

void bench_all_worlds(const Command& command, const BenchArguments& arguments, JsonWriter& json,
                      BenchResult& measured) {
    WorldsBenchOptions options = arguments.worlds;
    if (options.worlds == 0) return;
    options.steps = arguments.steps.steps;
    options.runs = arguments.steps.runs;
    options.threads = arguments.steps.threads == 1 ? 0 : arguments.steps.threads;
    narrate_progress("measuring " + std::to_string(options.worlds) + " worlds\n");
    const WorldsBenchResult result = bench_worlds(options);
    measured.worlds = result;
    measured.world_count = options.worlds;
    json.open_object()
        .member("worlds", options.worlds)
        .member("steps_per_second_serial", result.serial_rate)
        .member("steps_per_second", result.parallel_rate)
        .member("ratio", result.ratio())
        .close_object();
    if (command.json) return;
    char line[160];
    std::snprintf(line, sizeof line, "%d worlds: %.0f steps/s on one thread, %.0f on all, ratio %.2f   (wall clock)\n",
                  options.worlds, result.serial_rate, result.parallel_rate, result.ratio());
    write_output(line);
}

void write_row(const GrowthResult& row) {
    char line[160];
    std::snprintf(line, sizeof line, "%-14s %8d %8d %12.4f %10.0f %10.2f %10.2f %12.1f\n", row.world.c_str(),
                  row.bodies, row.awake, row.step_us, row.bytes, row.load_us, row.build_us, row.frame_ms);
    write_output(line);
}

void write_row(JsonWriter& json, const GrowthResult& row) {
    json.open_object()
        .member("world", row.world)
        .member("bodies", row.bodies)
        .member("awake", row.awake)
        .member("step_us", row.step_us)
        .member("bytes", row.bytes)
        .member("load_us", row.load_us)
        .member("build_us", row.build_us)
        .member("frame_ms", row.frame_ms)
        .close_object();
}

void bench_all_growth(const Command& command, int most_bodies, JsonWriter& json, BenchResult& result) {
    if (most_bodies == 0) return;
    const GrowthOptions options{.runs = result.options.runs, .threads = result.options.threads};
    if (!command.json)
        write_output(
            "world            bodies    awake      step us      bytes    load us   build us     frame ms"
            "   (per body, but for the frame; wall clock)\n");
    for (const GrowthName& world : kGrowthWorlds)
        for (const int bodies : growth_sizes(most_bodies)) {
            narrate_progress("measuring " + std::string(world.name) + ", " + counted(bodies, "body") + "\n");
            const GrowthResult row = bench_growth(world, bodies, options);
            result.growth.push_back(row);
            write_row(json, row);
            if (!command.json) write_row(row);
        }
}

ExitCode bench(const Command& command, const BenchArguments& options) {
    if (!options.report.empty()) refuse_to_overwrite(options.report, options.force);
    std::vector<Scene> scenes;  // read first, so that an error in one is not reported after minutes of measurements
    for (const std::string& name : options.scenes) scenes.push_back(load_named_scene(find_scene(name).string()));
    std::optional<V3Program> v3_program;
    if (!options.v3_program.empty()) v3_program.emplace(options.v3_program);
    BenchResult result{.queries = {}, .steps = {}, .options = options.steps};
    if (v3_program) result.options.v3_program = &*v3_program;
    JsonWriter json;
    json.open_object().key("distance").open_array();
    bench_all_queries(command, options.queries, json, result);
    json.close_array().key("step").open_array();
    bench_all_scenes(command, scenes, json, result);
    json.close_array().key("worlds").open_array();
    bench_all_worlds(command, options, json, result);
    json.close_array().key("growth").open_array();
    bench_all_growth(command, options.most_bodies, json, result);
    json.close_array().key("render").open_array().close_array().key("machine");
    write_machine(json);
    write_engines(json, reference::has_box2d_v3());
    json.close_object();
    write_output(command.json ? json.text() + "\n" : engines_text(reference::has_box2d_v3()));
    if (!options.report.empty()) {
        write_file(options.report, bench_page(result), options.force);
        narrate_progress("report written to " + options.report + "\n");
    }
    return ExitCode::ok;
}

}  // namespace

void add_bench(CLI::App& app, Command& command) {
    const auto options = std::make_shared<BenchArguments>();
    CLI::App& app_bench =
        add_subcommand(app, command, "bench", "Time queries and the world step of tumble and of Box2D");
    app_bench.add_option("--scenes", options->scenes, "Names of shipped scenes, or scene files, separated by commas")
        ->delimiter(',')
        ->capture_default_str();
    app_bench.add_option("--pairs", options->queries.pairs, "Pairs of shapes per query case; 0 skips the queries")
        ->capture_default_str()
        ->check(whole_number_from_to(0, 10000000));
    app_bench.add_option("--steps", options->steps.steps, "Steps per run")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 100000));
    app_bench.add_option("--runs", options->steps.runs, "Runs of each engine; the median is reported")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 1000));
    add_threads_option(app_bench, options->steps.threads);
    app_bench
        .add_option("--worlds", options->worlds.worlds,
                    "Also step N small worlds at once, on one thread and on --threads or all")
        ->capture_default_str()
        ->check(whole_number_from_to(0, 100000));
    app_bench
        .add_option("--growth", options->most_bodies,
                    "Also measure worlds of 1000 to N bodies, ten times as many each time")
        ->capture_default_str()
        ->check(whole_number_from_to(kSmallestGrowth, kLargestGrowth));
    app_bench
        .add_option("--box2d-v3", options->v3_program,
                    "The benchmark program of Box2D v3, which then times the scenes that it has")
        ->type_name("PROGRAM")
        ->check(CLI::ExistingFile);
    allow_standard_output(
        *app_bench.add_option("--report", options->report, "Write an HTML page with tables and plots")
             ->type_name("F.html"))
        .check(page_name());
    app_bench.add_flag("--force", options->force, "Replace an existing report");
    app_bench.callback(
        [&command, options] { command.action = [&command, options] { return bench(command, *options); }; });
}

}  // namespace tumble::tools
