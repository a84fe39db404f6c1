// The one place that knows which exception means which exit code.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "tools/cli/exit_code.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

// What went wrong, as the process tells it.
struct Problem {
    ExitCode code = ExitCode::internal_error;
    std::string message;
    std::vector<Diagnostic> diagnostics;
};

Problem explain(const std::exception_ptr& exception);

// Says on standard error what went wrong, with --json also as {"error": {...}} on standard output.
ExitCode report_exception(const std::exception_ptr& exception, bool json);

// An array with an object for each diagnostic.
void write_diagnostics(JsonWriter& json, const std::vector<Diagnostic>& diagnostics);

}  // namespace tumble::tools
