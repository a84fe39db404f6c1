// Collects the errors and warnings of a scene and, at the end, finds their lines and columns in its text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/json/included_parts.hpp"
#include "scene/json/problem_codes.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::scene {

inline constexpr std::size_t kMaxDiagnostics = 20;

class Diagnostics {
public:
    // `text` must outlive the object; empty if the scene was made in memory.
    Diagnostics(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

    // Values at and below `pointer` come from `origin` ("--set /a/b=1"), not from the text.
    void add_origin(std::string pointer, std::string origin);

    // Entries that other files contain: errors in them are located at the entry that includes the file.
    void set_included(IncludedParts included) { included_ = std::move(included); }

    // "/bodies/3", or "/bodies/1 of parts/car.json".
    std::string name_of(const std::string& pointer) const;

    // Adds the diagnostics of a file that the entry at `include` includes.
    void adopt(const std::vector<Diagnostic>& found, const std::string& include);

    enum class At { value, key };
    void error(std::string pointer, std::string message, std::string hint = "", At at = At::value);
    // The code is one of `codes` in problem_codes.hpp. Errors have that of the key in which they occur.
    void warning(std::string_view code, std::string pointer, std::string message, std::string hint = "");
    // An error in the text of the string at the pointer, `inside` bytes from its start.
    void error_in_text(std::string pointer, std::size_t inside, std::string message, std::string hint = "");
    // A text that is not JSON; `code` is that of another problem.
    void error_at_offset(std::size_t offset, std::string message, std::string hint = "",
                         std::string_view code = codes::json);

    bool has_errors() const { return !errors_.empty() || !adopted_errors_.empty(); }

    // Whether an error was found at or below the pointer: further checks of that part would only repeat it.
    bool has_errors_in(std::string_view pointer) const;

    // Throws SceneError with all errors in the order of the text. Without errors, appends the warnings to `warnings`.
    void finish(std::vector<Diagnostic>* warnings);

private:
    struct Entry {
        std::string pointer;
        std::string message;
        std::string hint;
        At at = At::value;
        std::size_t offset = std::string_view::npos;  // known for syntax errors only
        std::size_t inside = std::string_view::npos;  // in the text of a string
        std::string_view code{};                      // static; empty for errors
    };

    struct Adopted {
        Diagnostic diagnostic;
        std::string include;  // pointer
    };

    Diagnostic locate(const Entry& entry, Diagnostic::Severity severity) const;
    std::vector<Diagnostic> locate_all(const std::vector<Entry>& entries, const std::vector<Adopted>& adopted,
                                       Diagnostic::Severity severity) const;

    std::string file_;
    std::string_view text_;
    std::vector<std::pair<std::string, std::string>> origins_;
    std::vector<Entry> errors_;
    std::vector<Entry> warnings_;
    std::vector<Adopted> adopted_errors_;
    std::vector<Adopted> adopted_warnings_;
    IncludedParts included_;
    bool overflowed_ = false;
};

}  // namespace tumble::scene
