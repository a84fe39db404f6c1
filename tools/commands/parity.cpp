// `tumble parity`: compares distances, rays, casts and times of impact with Box2D, and checks both by exact arithmetic.
#include <CLI/CLI.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/families/cast_families.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/parity.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/parity/parity_page.hpp"
#include "tools/parity/parity_report.hpp"
#include "tools/scene/data_paths.hpp"
#include "tools/scene/scene_options.hpp"

namespace tumble::tools {

namespace {

constexpr std::uint64_t kMostPairs = 1000000000;  // one or two hours, and 200 MB for the list of blocks

constexpr const char* kAgainstV3 = "box2d-v3";

struct ParityArguments {
    reference::ParityOptions parity;
    std::string against = "box2d";
    std::vector<std::string> scenes;
    std::string report;
    bool force = false;
    bool list = false;
};

ExitCode list_families(const Command& command) {
    JsonWriter json;
    json.open_array();
    const auto list = [&](const auto& family) {
        json.open_object().member("name", family.name).member("description", family.description).close_object();
        std::string line(family.name);
        line.resize(24, ' ');
        if (!command.json) write_output(line + std::string(family.description) + "\n");
    };
    for (const reference::PairFamily& family : reference::pair_families()) list(family);
    for (const reference::CastFamily& family : reference::cast_families()) list(family);
    json.close_array();
    if (command.json) write_output(json.text() + "\n");
    return ExitCode::ok;
}

// One result with the rows of all scenes.
reference::ParityResult compare_scenes(const ParityArguments& options) {
    reference::ParityResult all;
    all.seed = options.parity.seed;
    for (const std::string& name : options.scenes) {
        narrate_progress("comparing every pair of every step of " + name + "\n");
        const reference::ParityResult one =
            reference::run_scene_parity(load_named_scene(find_scene(name).string()), options.parity);
        all.pairs += one.pairs;
        all.seconds += one.seconds;
        all.families.insert(all.families.end(), one.families.begin(), one.families.end());
    }
    return all;
}

reference::ParityResult compare_random_pairs(const ParityArguments& options) {
    for (const std::string& name : options.parity.families)
        if (!reference::find_pair_family(name) && !reference::find_cast_family(name))
            throw CLI::ValidationError("--family",
                                       "there is no family '" + name + "'; tumble parity --list names them all");
    Progress progress("pairs", options.parity.pairs);
    reference::ParityOptions parity = options.parity;
    parity.progress = [&progress](std::uint64_t done) { progress.show(done); };
    return reference::run_parity(parity);
}

reference::ParityResult compare_pairs(const ParityArguments& options) {
    return options.scenes.empty() ? compare_random_pairs(options) : compare_scenes(options);
}

// With both engines, or with Box2D alone.
ParityResults compare_engines(const ParityArguments& options) {
    ParityResults results{compare_pairs(options)};
    if (options.against != kAgainstV3) return results;
    narrate_progress("the same pairs, compared with Box2D v3\n");
    ParityArguments with_v3 = options;
    with_v3.parity.opponent = reference::Opponent::box2d_v3;
    results.box2d_v3 = compare_pairs(with_v3);
    return results;
}

ExitCode compare(const Command& command, const ParityArguments& options) {
    if (options.against == kAgainstV3 && !reference::has_box2d_v3())
        throw CLI::ValidationError("--against",
                                   "this build has no Box2D v3; configure one with the CMake option "
                                   "TUMBLE_BOX2D_V3, the folder in which it is installed");
    if (options.list) return list_families(command);
    if (!options.report.empty()) refuse_to_overwrite(options.report, options.force);
    const bool in_scenes = !options.scenes.empty();
    const ParityResults results = compare_engines(options);
    if (command.json) {
        JsonWriter json;
        write_parity_json(json, results);
        write_output(json.text() + "\n");
    } else {
        write_report(parity_table(results));
    }
    if (!options.report.empty()) {
        write_file(options.report,
                   parity_page(results, in_scenes ? "Every pair of every step of the scenes" : "Random and hard pairs"),
                   options.force);
        narrate_progress("report written to " + options.report + "\n");
    }
    return results.box2d.passed() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_parity(CLI::App& app, Command& command) {
    const auto options = std::make_shared<ParityArguments>();
    CLI::App& parity =
        add_subcommand(app, command, "parity",
                       "Compare distances with Box2D's and with exact arithmetic; exit code 7 if tumble is wrong");
    parity.add_option("--pairs", options->parity.pairs, "Number of random pairs")
        ->capture_default_str()
        ->check(whole_number_from_to(1, kMostPairs));
    parity.add_option("--seed", options->parity.seed, "Seed of the pairs")->capture_default_str()->check(any_seed());
    parity.add_option("--family", options->parity.families, "Only this family of pairs; repeatable");
    parity.add_option("--scene", options->scenes, "Compare every pair of every step of this scene instead; repeatable");
    parity.add_option("--against", options->against, "The engine to compare with: box2d, or box2d-v3 beside it")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember({"box2d", kAgainstV3}));
    parity.add_option("--threads", options->parity.threads, "Threads; 0: one per processor")
        ->capture_default_str()
        ->check(whole_number_from_to(0, 256));
    allow_standard_output(
        *parity.add_option("--report", options->report, "Write an HTML page with plots and the worst cases")
             ->type_name("F.html"))
        .check(page_name());
    parity.add_flag("--force", options->force, "Replace an existing report");
    parity.add_flag("--list", options->list, "List the families");
    parity.parse_complete_callback([&parity] { warn_of_unused(parity, {"--pairs", "--seed", "--family"}, "--scene"); });
    parity.callback(
        [&command, options] { command.action = [&command, options] { return compare(command, *options); }; });
}

}  // namespace tumble::tools
