// Scene files: reading and writing a Scene as JSON, the diagnostics of a file, and the JSON schema.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// An error or a warning about a scene file, with its location and a hint.
struct Diagnostic {
    enum class Severity { error, warning };
    Severity severity = Severity::error;
    std::string file;                        // or the argument: "--set /a/b=1", "--seed 7"
    int line = 0;                            // from 1; 0 if the location is unknown
    int column = 0;                          // from 1, in bytes
    std::string pointer;                     // JSON pointer of the value
    std::string message;                     // "must be greater than 0, got -1"
    std::string source_line;                 // the line of the file, for the caret
    std::string hint;                        // may be empty
    std::vector<std::string> included_by{};  // "file:line:column" of the entries that include the file, innermost first
    bool is_of_argument = false;             // the value comes from LoadOptions: an override or the seed
    std::string code{};                      // of its page in problems()
};

// "file:line:column: pointer: message [code]", then the source line, a caret, the hint, and the files that include this
// one.
std::string to_string(const Diagnostic& diagnostic);

// A scene that is not valid: its errors, at most 20. what() is their text.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<Diagnostic> diagnostics);
    std::vector<Diagnostic> diagnostics;
};

// Returns the text of an included file, or throws FileError.
using ReadIncluded = std::function<std::string(const std::filesystem::path& file)>;

// Options of load_scene() and parse_scene().
struct LoadOptions {
    std::vector<std::string> overrides;  // "/json/pointer=value" each; a value that is not JSON is taken as a string
    std::optional<std::uint64_t> seed;   // replaces /world/seed

    // Also warn about valid scenes whose bodies overlap, sag or cannot keep their joints. Builds the world and steps it
    // once to find out.
    bool lint = false;

    // Keep Scene::include and do not add the included entries, so that to_json() gives a file with the same includes.
    bool keep_includes = false;

    // Accept paths in scenes (included files, images, pictures and reference scenes of claims) that lead out of the
    // folder of the file that names them. A text that cannot read files may name any.
    bool allow_outside = false;

    ReadIncluded read_included{};  // default: from the file system for load_scene(), none for parse_scene()
};

// Reads a scene and the files that it includes. Throws FileError (not readable) or SceneError (not valid). Warnings are
// appended to `warnings` if it is not null. Wrong overrides are SceneErrors too, see Diagnostic::is_of_argument.
Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings = nullptr);
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options,
                 std::vector<Diagnostic>* warnings = nullptr);
// A scene file that is read and parsed once, for many scenes that differ in their overrides and seeds. Files that it
// includes are read each time. Threads may share it.
class SceneSource {
public:
    // Throws FileError.
    explicit SceneSource(const std::filesystem::path& file, const ReadIncluded& read = {});
    ~SceneSource();
    SceneSource(SceneSource&&) noexcept;
    SceneSource& operator=(SceneSource&&) noexcept;

    // The scene that load_scene() gives with these options.
    Scene load(const LoadOptions& options, std::vector<Diagnostic>* warnings = nullptr) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A text can include files only through options.read_included. Their paths are relative to the folder of `file_name`.
Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings = nullptr);
Scene parse_scene(std::string_view text, const std::string& file_name, const LoadOptions& options,
                  std::vector<Diagnostic>* warnings = nullptr);

// What a program finds wrong in a value that it reads itself, such as one in Scene::custom.
struct ValueProblem {
    std::string message;
    std::string hint{};                   // may be empty
    bool at_key = false;                  // the key of the value is wrong, not the value
    std::optional<std::size_t> inside{};  // of a string: the error is so many bytes from its start
};

// Throws a SceneError with the line and the column that the value has in the text of its file, which parse_scene() has
// read. For a pointer that leads beyond what the text contains, they are those of the innermost value that exists.
void refuse_value(std::string_view text, const std::string& file_name, const std::string& pointer,
                  const ValueProblem& problem);

// The canonical text: keys in the schema's order, defaults left out, shortest round-trip numbers. Throws
// std::invalid_argument for a `custom` that is not JSON.
std::string to_json(const Scene& scene);

// Writes the canonical text to a temporary file and renames it. Throws as to_json(), and FileError.
void save_scene(const Scene& scene, const std::filesystem::path& file);

// The text of a scene file, read without error, with another string as the value at a JSON pointer. Comments and layout
// stay. Throws std::invalid_argument if there is no string at the pointer.
std::string replace_text(std::string_view scene_text, const std::string& pointer, std::string_view text);

// The JSON schema (Draft-07) of format 1, as published in scenes/scene.schema.json.
std::string scene_schema();

// Clears what neither a run nor its frames depend on: $schema, description, claims, custom data, and the record of
// which numbers were drawn (the numbers stay).
void leave_out_remarks(Scene& scene);

// xxHash64 of the canonical text of the simulated part: all but $schema, name, description, camera, colours, claims and
// custom data. Scenes with equal simulated parts have equal hashes.
std::uint64_t scene_hash(const Scene& scene);

// Reads a shape of the scene format, {"box": {"size": [2, 1]}}, for a distance query: radii of 0 are allowed, and a
// polygon is the exact hull of its vertices, as make_exact_shapes() makes it. The result is one shape, or several for
// chains and outlines. Throws SceneError, with `source` as the name of the file.
std::vector<Shape> parse_shapes(std::string_view text, const std::string& source);

// What tumble reports, by code: warnings and errors of scenes, and exit codes. One table for lints, errors and help.
struct ProblemPage {
    enum class Kind { warning, error, exit_code };

    Kind kind = Kind::warning;
    std::string_view code;     // "stiff-spring", as in Diagnostic::code
    std::string_view title;    // one line
    std::string_view meaning;  // sentences
    std::string_view example;  // a scene with the problem; for an exit code, a command
    std::string_view remedy;   // sentences
};

// Warnings, errors and exit codes, in this order.
std::span<const ProblemPage> problems();

// The page of a code; null for another text.
const ProblemPage* find_problem(std::string_view code);

}  // namespace tumble
