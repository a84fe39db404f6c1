// `tumble distance`: the signed distance of two shapes, once or for each line of standard input.
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "command.hpp"
#include "console.hpp"
#include "distance_query.hpp"
#include "input_error.hpp"
#include "trace_output.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

namespace {

struct DistanceArguments {
    std::string a, b;
    bool from_input = false;
    std::string sub_algorithm;    // empty: distance() as it is
    std::filesystem::path trace;  // empty: not drawn
    bool force = false;
};

const std::map<std::string, SubAlgorithm> kSubAlgorithms = {{"voronoi", SubAlgorithm::voronoi},
                                                           {"johnson", SubAlgorithm::johnson},
                                                           {"signed-volumes", SubAlgorithm::signed_volumes}};

DistanceResult answer(const DistanceQuery& query, const DistanceArguments& options) {
    if (options.sub_algorithm.empty()) return tumble::distance(query.a, query.a_pose, query.b, query.b_pose);
    return gjk_distance(query.a, query.a_pose, query.b, query.b_pose, kSubAlgorithms.at(options.sub_algorithm));
}

ExitCode answer_arguments(const Command& command, const DistanceArguments& options) {
    const DistanceQuery query = parse_query_arguments(options.a, options.b);
    const DistanceResult result = answer(query, options);
    if (!options.trace.empty()) {
        const std::string& by = options.sub_algorithm.empty() ? "voronoi" : options.sub_algorithm;
        write_trace(options.trace, query, kSubAlgorithms.at(by), options.force);
    }
    if (!command.json) {
        write_output(answer_text(result));
        return ExitCode::ok;
    }
    JsonWriter json;
    write_answer(json, query, result);
    write_output(json.text() + "\n");
    return ExitCode::ok;
}

void write_line_error(JsonWriter& json, const std::string& message, std::uint64_t line) {
    json.clear();
    json.open_object().member("error", message).member("line", line).close_object();
}

// A line that is no query is answered by its error, and the next one is read. Who writes a line and waits gets its answer
// before we wait for the next one.
ExitCode answer_lines(const DistanceArguments& options) {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    ExitCode code = ExitCode::ok;
    JsonWriter json(JsonWriter::Layout::compact);
    std::string line;
    for (std::uint64_t number = 1; std::getline(std::cin, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        json.clear();
        try {
            const DistanceQuery query = parse_query_line(line);
            write_answer(json, query, answer(query, options));
        } catch (const InputError& error) {
            write_line_error(json, error.what(), number);
            code = ExitCode::invalid_input;
        } catch (const SceneError& error) {
            const Diagnostic& first = error.diagnostics.front();
            write_line_error(json, first.file + first.pointer + ": " + first.message, number);
            code = ExitCode::invalid_input;
        }
        write_output(json.text());
        write_output("\n");
        if (std::cin.rdbuf()->in_avail() <= 0) finish_output();
    }
    return code;
}

ExitCode run(const Command& command, const DistanceArguments& options) {
    if (!options.trace.empty() && (options.from_input || !is_trace_file(options.trace)))
        throw CLI::ValidationError("--trace", "expected a file .png, .svg or .json, for one query, got " + options.trace.string());
    if (options.from_input) return answer_lines(options);
    if (options.a.empty() || options.b.empty())
        throw CLI::RequiredError("A and B, two shapes as JSON, or --stdin,");
    return answer_arguments(command, options);
}

}  // namespace

void add_distance(CLI::App& app, Command& command) {
    const auto options = std::make_shared<DistanceArguments>();
    CLI::App& distance = add_subcommand(app, command, "distance", "The signed distance of two convex shapes");
    distance.add_option("A", options->a, R"(A shape, as in {"circle": {"radius": 1}, "pose": {"position": [2, 0]}})");
    distance.add_option("B", options->b, "Another");
    distance.add_flag("--stdin", options->from_input, "A query a line on standard input, an answer a line out");
    distance.add_option("--sub-algorithm", options->sub_algorithm, "By the GJK loop alone, with this subalgorithm")
        ->check(CLI::IsMember(&kSubAlgorithms))
        ->type_name("NAME");
    distance.add_option("--trace", options->trace, "Write the iterations of the one query")->type_name("F.png|.svg|.json");
    distance.add_flag("--force", options->force, "Replace the trace if it exists");
    distance.callback([&command, options] { command.action = [&command, options] { return run(command, *options); }; });
}

}  // namespace tumble::tools
