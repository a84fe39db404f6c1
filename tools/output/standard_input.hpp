// Standard input in place of a file: "-" or "/dev/stdin". It is read once and kept, so that a command may read it
// twice.
#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "tumble/scene_file.hpp"

namespace tumble::tools {

bool is_standard_input(const std::filesystem::path& file);

// All bytes of standard input, at most 1 GiB. Throws FileError, or InputError if there are more.
const std::string& standard_input();

// Opens a file or standard input. Throws as standard_input().
std::unique_ptr<std::istream> open_input(const std::filesystem::path& file);

// The bytes of a file or of standard input. Throws as standard_input().
std::string read_input(const std::filesystem::path& file);

// load_scene(), also from standard input: its includes are then relative to the current folder, and its errors name
// the file "<stdin>".
Scene load_scene_input(const std::filesystem::path& file, const LoadOptions& options = {},
                       std::vector<Diagnostic>* warnings = nullptr);

}  // namespace tumble::tools
