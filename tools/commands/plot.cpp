// `tumble plot`: values of expressions over the time of a run, or over each other, as a picture or a table.
#include <CLI/CLI.hpp>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/plot/expression_plots.hpp"
#include "tools/plot/expression_table.hpp"
#include "tools/run/run_options.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/tables/step_files.hpp"

namespace tumble::tools {

namespace {

// Of one picture: more would need more than a gigabyte.

enum class Format { svg, png, csv };

struct PlotArguments {
    SceneOptions scene;
    std::vector<std::string> expressions;
    std::string against;
    std::filesystem::path file;
    std::optional<std::string> format;
    std::optional<double> duration;
    FrameSize size;
    RenderBackend renderer = RenderBackend::automatic;
    bool is_together = false;
    bool force = false;

    // The expressions and, last, that of the horizontal axis.
    std::vector<std::string> texts() const {
        std::vector<std::string> all = expressions;
        if (!against.empty()) all.push_back(against);
        return all;
    }
};

Format format_of(const PlotArguments& options) {
    const std::string name = options.format.value_or(
        is_standard_output(options.file) ? "csv" : options.file.extension().string().erase(0, 1));
    if (name == "svg") return Format::svg;
    if (name == "png") return Format::png;
    if (name == "csv") return Format::csv;
    throw CLI::ValidationError("--output",
                               "expected a file name that ends in .svg, .png or .csv, got " + options.file.string());
}

std::string header_of(const std::vector<std::string>& texts) {
    std::string line = "step,time";
    for (const std::string& text : texts) line += "," + csv_field(text);
    return line + "\n";
}

std::string line_of(std::uint64_t step, double time, std::span<const double> values) {
    std::string line = std::to_string(step) + ",";
    append_number(line, time);
    for (const double value : values) {
        line += ",";
        append_number(line, value);
    }
    return line + "\n";
}

std::string picture(Format format, const std::vector<Plot>& plots, RenderBackend renderer) {
    if (format == Format::svg) return to_svg(plots);
    return to_png(draw_image(to_drawing(plots), renderer));
}

std::string exact_text(double number) {
    std::string text;
    append_number(text, number);
    return text;
}

std::string text_report(const PlotArguments& options, const std::vector<ColumnSummary>& columns) {
    std::string text = options.file.string() + "\n";
    const std::vector<std::string> texts = options.texts();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ColumnSummary& column = columns[i];
        text += "  " + texts[i] + ": " + exact_text(column.least) + " (" + exact_text(column.least_time) + " s) to " +
                exact_text(column.greatest) + " (" + exact_text(column.greatest_time) + " s), last " +
                exact_text(column.last);
        if (column.unknown > 0) text += ", unknown in " + std::to_string(column.unknown) + " states";
        text += "\n";
    }
    return text;
}

std::string json_report(const PlotArguments& options, const ExpressionTable& table,
                        const std::vector<ColumnSummary>& columns) {
    JsonWriter json;
    json.open_object().member("file", options.file.string()).member("complete", !table.failure);
    json.member("state_hash", to_hex(table.state_hash)).key("expressions").open_array();
    const std::vector<std::string> texts = options.texts();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ColumnSummary& column = columns[i];
        json.open_object().member("expression", texts[i]).member("least", column.least);
        json.member("least_time", column.least_time).member("greatest", column.greatest);
        json.member("greatest_time", column.greatest_time).member("last", column.last);
        json.member("unknown", column.unknown).close_object();
    }
    json.close_array().close_object();
    return json.text() + "\n";
}

ExitCode plot(const Command& command, const PlotArguments& options) {
    const Format format = format_of(options);
    const bool is_table = format == Format::csv;
    const Scene scene = read_scene(options.scene);
    const std::vector<std::string> texts = options.texts();
    compile_expressions(scene, texts);  // before a file is created
    if (!is_table) require_few_values(scene, texts.size(), options.duration);
    OutputFile file = open_output(options.file, options.force);
    if (is_table) file.write(header_of(texts));
    ColumnSummaries summaries(texts.size());
    const RowWriter write = [&](std::uint64_t step, double time, std::span<const double> values) {
        summaries.add(time, values);
        if (is_table) file.write(line_of(step, time, values));
    };
    const ExpressionTable table =
        run_expressions(scene, texts, {.duration = options.duration, .keeps_values = !is_table, .write = write});
    if (!is_table)
        file.write(picture(format,
                           plots_of(table, {.has_abscissa = !options.against.empty(),
                                            .is_together = options.is_together,
                                            .width = options.size.width,
                                            .height = options.size.height,
                                            .title = scene.name}),
                           options.renderer));
    file.commit();
    command.json ? write_output(json_report(options, table, summaries.columns()))
                 : write_report(text_report(options, summaries.columns()));
    if (table.failure) std::rethrow_exception(table.failure);
    return ExitCode::ok;
}

}  // namespace

void add_plot(CLI::App& app, Command& command) {
    const auto options = std::make_shared<PlotArguments>();
    CLI::App& plot_app =
        add_subcommand(app, command, "plot", "Plot expressions over the time of a run, or over each other");
    add_scene_options(plot_app, options->scene);
    plot_app
        .add_option("EXPRESSION", options->expressions,
                    "What to plot: ball.y, ball.speed, \"kinetic + potential\"; the grammar is that of claims")
        ->required();
    allow_standard_output(*plot_app
                               .add_option("-o,--output", options->file,
                                           "Picture (.svg, .png) or table (.csv) to write; - is standard output")
                               ->type_name("F")
                               ->required());
    plot_app.add_option("--format", options->format, "svg, png or csv; default: by the name of the file, csv for -")
        ->check(CLI::IsMember({"svg", "png", "csv"}));
    plot_app.add_option("--against", options->against, "The expression of the horizontal axis; default: the time")
        ->type_name("EXPRESSION");
    plot_app.add_flag("--together", options->is_together, "All expressions over one axis; default: one plot for each");
    plot_app.add_option("--duration", options->duration, "Simulated time in seconds; default: that of the scene")
        ->type_name("S")
        ->check(number_from_to(0.0, kMaxDuration));
    add_size_option(plot_app, options->size);
    add_renderer_option(plot_app, options->renderer);
    plot_app.add_flag("--force", options->force, "Replace the file if it exists");
    plot_app.callback(
        [&command, options] { command.action = [&command, options] { return plot(command, *options); }; });
}

}  // namespace tumble::tools
