// Scene files: reading and writing a Scene as JSON, what is wrong with one and where, and its schema.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// Where a scene file is wrong and how to mend it.
struct Diagnostic {
    enum class Severity { error, warning };
    Severity severity = Severity::error;
    std::string file;
    int line = 0;                            // from 1; 0 if the place is unknown
    int column = 0;                          // from 1, in bytes
    std::string pointer;                     // JSON pointer of the value
    std::string message;                     // "must be greater than 0, got -1"
    std::string source_line;                 // the line of the file, for the caret
    std::string hint;                        // may be empty
    std::vector<std::string> included_by{};  // "file:line:column" of what includes the file, innermost first
};

// "file:line:column: pointer: message", the source line, the caret, the hint, who includes the file.
std::string to_string(const Diagnostic& diagnostic);

// A scene that cannot be read: all its errors, at most 20; what() is their text.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<Diagnostic> diagnostics);
    std::vector<Diagnostic> diagnostics;
};

// Gives the text of an included file, or throws FileError.
using ReadIncluded = std::function<std::string(const std::filesystem::path& file)>;

// What a caller changes in a scene before it is read.
struct LoadOptions {
    std::vector<std::string> overrides;  // "/json/pointer=value" each; a value that is not JSON is taken as a string
    std::optional<std::uint64_t> seed;   // replaces /world/seed
    bool lint = false;  // warn of what is valid but likely to disappoint; builds the world and steps it once
    bool keep_includes =
        false;  // leave Scene::include as it is written, what it includes out: to write the scene again
    ReadIncluded read_included{};  // default: from the file system for load_scene(), none for parse_scene()
};

// Reads a scene, and what it includes. Throws FileError (not readable) or SceneError (not valid). Warnings, if asked
// for, are appended. Wrong overrides are SceneErrors too: their diagnostics have the override in place of the file, and
// no line.
Scene load_scene(const std::filesystem::path& file, std::vector<Diagnostic>* warnings = nullptr);
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options,
                 std::vector<Diagnostic>* warnings = nullptr);
// A text includes files only by options.read_included; `file_name` is where their paths start from.
Scene parse_scene(std::string_view text, const std::string& file_name, std::vector<Diagnostic>* warnings = nullptr);
Scene parse_scene(std::string_view text, const std::string& file_name, const LoadOptions& options,
                  std::vector<Diagnostic>* warnings = nullptr);

// The canonical text: keys in the schema's order, defaults left out, shortest round-trip numbers. Throws
// std::invalid_argument for a `custom` that is not JSON.
std::string to_json(const Scene& scene);
void save_scene(const Scene& scene,
                const std::filesystem::path& file);  // written aside, then renamed; throws FileError

// The JSON schema (Draft-07) of format 1, as published in scenes/scene.schema.json.
std::string scene_schema();

// xxHash64 of what is simulated, as canonical text: everything but $schema, name, description, camera, colours,
// expectations and custom. Equal simulations, equal hashes.
std::uint64_t scene_hash(const Scene& scene);

// Reads a shape as scene files write it, {"box": {"size": [2, 1]}}, for a distance query: radii of 0 are allowed, and a
// polygon is the exact hull of its vertices, as make_exact_shapes() makes it. One shape, or several for chains and
// outlines. Throws SceneError; `source` stands where the file's name would.
std::vector<Shape> parse_shapes(std::string_view text, const std::string& source);

}  // namespace tumble
