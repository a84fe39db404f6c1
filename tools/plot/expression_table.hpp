// The values of expressions in each state of a run: what `plot` draws and writes.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

// Compiles expressions of a scene. Throws CLI::ValidationError with the place in the text for one that is wrong.
std::vector<Expression> compile_expressions(const Scene& scene, std::span<const std::string> texts);

// Throws CLI::ValidationError if a table of a run has more than 30 million values: steps times expressions.
void require_few_values(const Scene& scene, std::size_t expressions, std::optional<double> duration);

// The value of one expression: [state], in the order of time. NaN is unknown, as of a body that does not exist.
struct ExpressionColumn {
    std::string text;
    std::vector<double> values;
};

// The states of a run, from the initial one on.
struct ExpressionTable {
    std::vector<std::uint64_t> steps;
    std::vector<double> times;  // s
    std::vector<ExpressionColumn> columns;
    std::uint64_t state_hash = 0;  // of the last state
    std::exception_ptr failure;    // SimulationDiverged, if the run ended by it
};

// A row of the table: the step, its time and the value of each expression.
using RowWriter = std::function<void(std::uint64_t step, double time, std::span<const double> values)>;

struct TableOptions {
    std::optional<double> duration;  // s; without it the scene's
    bool keeps_values = true;        // in the table; the writer gets them in any case
    RowWriter write{};               // may be empty
};

// Simulates the scene. A run that diverges gives the rows before that, and the failure; one that is interrupted the
// rows before that.
ExpressionTable run_expressions(const Scene& scene, std::span<const std::string> texts, const TableOptions& options);

// Numbers that say most of one column: of the known values, NaN if there is none.
struct ColumnSummary {
    double least = 0.0, least_time = 0.0;
    double greatest = 0.0, greatest_time = 0.0;
    double last = 0.0;          // the value in the last state
    std::uint64_t unknown = 0;  // number of NaN
};

// Summaries are made while the run goes on, so that they need no table.
class ColumnSummaries {
public:
    explicit ColumnSummaries(std::size_t columns);
    void add(double time, std::span<const double> values);
    const std::vector<ColumnSummary>& columns() const noexcept { return columns_; }

private:
    std::vector<ColumnSummary> columns_;
};

}  // namespace tumble::tools
