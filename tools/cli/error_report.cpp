#include "tools/cli/error_report.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/output/input_error.hpp"
#include "tumble/render.hpp"
#include "tumble/world.hpp"

namespace tumble::tools {

ExitCode code_of(const SceneError& error) {
    const bool is_of_arguments = std::ranges::all_of(error.diagnostics, &Diagnostic::is_of_argument);
    return is_of_arguments && !error.diagnostics.empty() ? ExitCode::usage : ExitCode::invalid_input;
}

Problem explain(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const SceneError& error) {
        return {code_of(error), error.what(), error.diagnostics};
    } catch (const InputError& error) {
        return {ExitCode::invalid_input, error.what(), {}};
    } catch (const PictureError& error) {
        return {ExitCode::invalid_input, error.what(), {}};
    } catch (const FileError& error) {
        return {ExitCode::file_system, error.what(), {}};
    } catch (const std::filesystem::filesystem_error& error) {
        return {ExitCode::file_system, error.what(), {}};
    } catch (const RenderError& error) {
        return {ExitCode::rendering, error.what(), {}};
    } catch (const SimulationDiverged& error) {
        return {ExitCode::diverged, error.what(), {}};
    } catch (const std::bad_alloc&) {
        return {ExitCode::internal_error, "out of memory", {}};
    } catch (const std::exception& error) {
        return {ExitCode::internal_error, std::string("internal error, a bug in tumble: ") + error.what(), {}};
    } catch (...) {
        return {ExitCode::internal_error, "internal error, a bug in tumble: an exception of unknown type", {}};
    }
}

void write_diagnostics(JsonWriter& json, const std::vector<Diagnostic>& diagnostics) {
    json.open_array();
    for (const Diagnostic& diagnostic : diagnostics) {
        json.open_object()
            .member("code", diagnostic.code)
            .member("severity", diagnostic.severity == Diagnostic::Severity::error ? "error" : "warning")
            .member("file", diagnostic.file)
            .member("line", diagnostic.line)
            .member("column", diagnostic.column)
            .member("pointer", diagnostic.pointer)
            .member("message", diagnostic.message)
            .member("hint", diagnostic.hint)
            .member("included_by", diagnostic.included_by)
            .close_object();
    }
    json.close_array();
}

ExitCode report_exception(const std::exception_ptr& exception, bool json) {
    const Problem problem = explain(exception);
    if (problem.diagnostics.empty())
        report_error(problem.message);
    else
        narrate(problem.message + (problem.message.ends_with('\n') ? "" : "\n"));
    if (json) {
        JsonWriter document;
        document.open_object().key("error").open_object();
        document.member("exit_code", static_cast<int>(problem.code)).member("message", problem.message);
        document.key("diagnostics");
        write_diagnostics(document, problem.diagnostics);
        document.close_object().close_object();
        write_output(document.text() + "\n");
    }
    return problem.code;
}

}  // namespace tumble::tools
