// Converts exceptions into messages and exit codes.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "tools/cli/exit_code.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

// An error as the process reports it.
struct Problem {
    ExitCode code = ExitCode::internal_error;
    std::string message;
    std::vector<Diagnostic> diagnostics;
};

// Wrong arguments if all errors are in --set and --seed, else invalid input.
ExitCode code_of(const SceneError& error);

Problem explain(const std::exception_ptr& exception);

// Writes the error to standard error and, with --json, as {"error": {...}} to standard output.
ExitCode report_exception(const std::exception_ptr& exception, bool json);

// Writes an array with one object per diagnostic.
void write_diagnostics(JsonWriter& json, const std::vector<Diagnostic>& diagnostics);

}  // namespace tumble::tools
