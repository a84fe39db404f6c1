// The one place that knows which exception means which exit code.
#pragma once

#include <exception>

#include "exit_code.hpp"
#include "json_writer.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// Says on standard error what went wrong, with --json also as {"error": {...}} on standard output.
ExitCode report_exception(const std::exception_ptr& exception, bool json);

// An array with an object for each diagnostic.
void write_diagnostics(JsonWriter& json, const std::vector<Diagnostic>& diagnostics);

}  // namespace tumble::tools
