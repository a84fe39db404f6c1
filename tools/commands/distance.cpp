// `tumble distance`: computes the signed distance of two shapes, for two arguments or for each line of standard input.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/input_error.hpp"
#include "tools/query/distance_query.hpp"
#include "tools/query/trace_output.hpp"
#include "tools/run/run_options.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

struct DistanceArguments {
    std::string a, b;
    bool from_input = false;
    std::string sub_algorithm;    // empty: distance() with its fast paths
    std::filesystem::path trace;  // empty: not written
    std::string trace_format;     // empty: by the extension
    RenderBackend renderer = RenderBackend::automatic;
    bool force = false;
};

const std::map<std::string, SubAlgorithm> kSubAlgorithms = {{"voronoi", SubAlgorithm::voronoi},
                                                            {"johnson", SubAlgorithm::johnson},
                                                            {"signed-volumes", SubAlgorithm::signed_volumes}};

const std::map<std::string, TraceFormat> kTraceFormats = {
    {"png", TraceFormat::png}, {"svg", TraceFormat::svg}, {"json", TraceFormat::json}};

SubAlgorithm loop_of(const DistanceArguments& options) {
    return options.sub_algorithm.empty() ? SubAlgorithm::voronoi : kSubAlgorithms.at(options.sub_algorithm);
}

// A trace shows the loop: its query is answered by the loop too, so that both have the same iterations.
DistanceResult answer(const DistanceQuery& query, const DistanceArguments& options) {
    if (options.sub_algorithm.empty() && options.trace.empty())
        return tumble::distance(query.a, query.a_pose, query.b, query.b_pose);
    return gjk_distance(query.a, query.a_pose, query.b, query.b_pose, loop_of(options));
}

TraceFormat format_of(const DistanceArguments& options) {
    if (!options.trace_format.empty()) return kTraceFormats.at(options.trace_format);
    if (const std::optional<TraceFormat> format = trace_format_of(options.trace)) return *format;
    if (is_standard_output(options.trace))
        throw CLI::ValidationError("--trace", "needs --trace-format on standard output");
    throw CLI::ValidationError(
        "--trace",
        "needs a file name that ends in .png, .svg or .json, or --trace-format, got " + options.trace.string());
}

ExitCode answer_arguments(const Command& command, const DistanceArguments& options) {
    const DistanceQuery query = parse_query_arguments(options.a, options.b);
    const DistanceResult result = answer(query, options);
    if (result.status == DistanceStatus::invalid) throw InputError("the distance of A and B is not a finite double");
    if (!options.trace.empty())
        write_trace(options.trace, format_of(options), query, loop_of(options), options.renderer, options.force);
    if (!command.json) {
        write_output(answer_text(result));
        return ExitCode::ok;
    }
    JsonWriter json;
    write_answer(json, query, result);
    write_output(json.text() + "\n");
    return ExitCode::ok;
}

// A line of the input: a query, or its error.
struct Line {
    std::uint64_t number = 0;
    DistanceQuery query;
    std::string error;
};

Line read_line(std::string_view text, std::uint64_t number) {
    try {
        return {number, parse_query_line(text), {}};
    } catch (const InputError& error) {
        return {number, {}, error.what()};
    } catch (const SceneError& error) {
        const Diagnostic& first = error.diagnostics.front();
        return {number, {}, first.file + first.pointer + ": " + first.message};
    }
}

std::vector<DistanceResult> answer_all(const std::vector<Line>& lines, const DistanceArguments& options) {
    std::vector<DistanceResult> results(lines.size());
    if (!options.sub_algorithm.empty()) {
        std::ranges::transform(lines, results.begin(), [&](const Line& line) { return answer(line.query, options); });
        return results;
    }
    std::vector<PosedPair> pairs;
    for (const Line& line : lines)
        pairs.push_back({&line.query.a, line.query.a_pose, &line.query.b, line.query.b_pose});
    distance_batch(pairs, results);
    return results;
}

void write_answers(const std::vector<Line>& lines, const DistanceArguments& options, JsonWriter& json) {
    const std::vector<DistanceResult> results = answer_all(lines, options);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        json.clear();
        if (lines[i].error.empty())
            write_answer(json, lines[i].query, results[i]);
        else
            json.open_object().member("error", lines[i].error).member("line", lines[i].number).close_object();
        write_output(json.text());
        write_output("\n");
    }
}

// A line that is not valid is answered by its error, and reading continues. Lines are answered in batches; before the
// loop waits for more input it answers all lines so far, so that a program can write one line and wait for the answer.
ExitCode answer_lines(const DistanceArguments& options) {
    constexpr std::size_t kAtOnce = 256;
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    ExitCode code = ExitCode::ok;
    JsonWriter json(JsonWriter::Layout::compact);
    std::vector<Line> lines;
    std::string text;
    for (std::uint64_t number = 1; std::getline(std::cin, text); ++number) {
        if (text.find_first_not_of(" \t\r") != std::string::npos) {
            lines.push_back(read_line(text, number));
            if (!lines.back().error.empty()) code = ExitCode::invalid_input;
        }
        const bool is_last_for_now = std::cin.rdbuf()->in_avail() <= 0;
        if (is_last_for_now || lines.size() == kAtOnce) {
            write_answers(lines, options, json);
            lines.clear();
        }
        if (is_last_for_now) finish_output();
    }
    write_answers(lines, options, json);
    return code;
}

ExitCode run(const Command& command, const DistanceArguments& options) {
    if (!options.trace.empty() && options.from_input)
        throw CLI::ValidationError("--trace", "is for a single query, not for --stdin");
    if (!options.trace.empty()) format_of(options);
    if (options.from_input && !options.a.empty())
        throw CLI::ValidationError("--stdin", "reads the queries from standard input; leave out A and B");
    if (options.from_input) return answer_lines(options);
    if (options.a.empty() || options.b.empty()) throw CLI::RequiredError("A and B (two shapes as JSON), or --stdin,");
    return answer_arguments(command, options);
}

}  // namespace

void add_distance(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DistanceArguments>();
    CLI::App& distance = add_subcommand(
        app, command, "distance",
        "Compute the signed distance of two convex shapes, with proof; a polygon is the exact hull of its "
        "vertices");
    distance.add_option("A", options->a, R"(A shape, as in {"circle": {"radius": 1}, "pose": {"position": [2, 0]}})");
    distance.add_option("B", options->b, "The second shape");
    distance.add_flag("--stdin", options->from_input,
                      "Read one query per line from standard input, write one answer per line");
    distance.add_option("--sub-algorithm", options->sub_algorithm, "Use the GJK loop only, with this subalgorithm")
        ->check(CLI::IsMember(&kSubAlgorithms))
        ->type_name("NAME");
    CLI::Option* const trace = &allow_standard_output(
        *distance
             .add_option("--trace", options->trace,
                         "Answer by the GJK loop, and write its iterations as a picture or as JSON; - is standard "
                         "output")
             ->type_name("F.png|.svg|.json"));
    distance
        .add_option("--trace-format", options->trace_format, "Format of the trace; default: the extension of its file")
        ->check(CLI::IsMember(&kTraceFormats))
        ->type_name("NAME")
        ->needs(trace);
    add_renderer_option(distance, options->renderer);
    distance.add_flag("--force", options->force, "Replace an existing trace");
    distance.callback([&command, options] { command.action = [&command, options] { return run(command, *options); }; });
}

}  // namespace tumble::tools
