#include "tools/plot/expression_table.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/cli/command.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"

namespace tumble::tools {

namespace {

// The number of characters in the first bytes of a UTF-8 text.
std::size_t characters_before(const std::string& text, std::size_t offset) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
    return static_cast<std::size_t>(std::count_if(
        text.begin(), end, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; }));
}

std::string error_text(const std::string& text, const ExpressionError& error) {
    const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
    const std::size_t place = characters_before(text, error.offset);
    return error.what() + hint + "\n  " + text + "\n  " + std::string(place, ' ') + "^";
}

}  // namespace

std::vector<Expression> compile_expressions(const Scene& scene, std::span<const std::string> texts) {
    std::vector<Expression> expressions;
    for (const std::string& text : texts) {
        try {
            expressions.emplace_back(text, scene);
        } catch (const ExpressionError& error) {
            throw CLI::ValidationError("EXPRESSION", error_text(text, error));
        }
    }
    return expressions;
}

void require_few_values(const Scene& scene, std::size_t expressions, std::optional<double> duration) {
    constexpr double kMostValues = 3e7;
    const double steps = duration.value_or(scene.world.duration) * scene.world.steps_per_second;
    if (steps * static_cast<double>(expressions) <= kMostValues) return;
    throw CLI::ValidationError("EXPRESSION",
                               "a plot has at most 30 million values; write a table (tumble plot -o F.csv), or give a "
                               "shorter --duration");
}

ExpressionTable run_expressions(const Scene& scene, std::span<const std::string> texts, const TableOptions& options) {
    const std::vector<Expression> expressions = compile_expressions(scene, texts);
    const double rate = scene.world.steps_per_second;
    const std::uint64_t last = nearest_step(options.duration.value_or(scene.world.duration), rate);
    ExpressionTable table;
    for (const std::string& text : texts) table.columns.push_back({text, {}});
    SceneRun run(scene);
    std::vector<double> values(expressions.size());
    const auto record = [&] {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = expressions[i].value(run.built());
        if (options.write) options.write(run.world().step_count(), run.time(), values);
        if (!options.keeps_values) return;
        table.steps.push_back(run.world().step_count());
        table.times.push_back(run.time());
        for (std::size_t i = 0; i < values.size(); ++i) table.columns[i].values.push_back(values[i]);
    };
    Progress progress("steps", last);
    record();
    try {
        while (run.world().step_count() < last && !run.is_stopped() && !is_interrupted()) {
            run.step();
            record();
            progress.show(run.world().step_count());
        }
    } catch (const SimulationDiverged&) {
        table.failure = std::current_exception();
    }
    table.state_hash = run.world().state_hash();
    return table;
}

ColumnSummaries::ColumnSummaries(std::size_t columns) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    columns_.resize(columns, {kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, 0});
}

void ColumnSummaries::add(double time, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        ColumnSummary& column = columns_[i];
        column.last = values[i];
        if (std::isnan(values[i])) {
            ++column.unknown;
            continue;
        }
        if (!(values[i] >= column.least)) column.least = values[i], column.least_time = time;
        if (!(values[i] <= column.greatest)) column.greatest = values[i], column.greatest_time = time;
    }
}

}  // namespace tumble::tools
