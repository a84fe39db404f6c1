// Creates output files: refuses to overwrite, creates missing folders, and lets "-" stand for standard output.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "tumble/file.hpp"

namespace CLI {
class Option;
class Validator;
}  // namespace CLI

namespace tumble::tools {

// Whether the path is that of standard output, /dev/stdout. It is never refused.
bool is_standard_output(const std::filesystem::path& file);

// Lets "-" stand for standard output in an option that names a file to write. The texts of the command then go to
// standard error. Two files on standard output are wrong arguments. Calls file_name().
CLI::Option& allow_standard_output(CLI::Option& option);

// For an option that names an HTML page or a CSV table: a name that promises another format is refused. Other names,
// as of temporary files, are not.
CLI::Validator page_name();
CLI::Validator table_name();

// For an option that names a file to write: an empty name is a wrong argument.
CLI::Validator file_name();

// For an option that names a folder: an empty name and standard output are wrong arguments.
CLI::Validator folder_name();

// The file as renaming into its place sees it: links in its folder are followed, the file itself is not.
std::filesystem::path place_of(const std::filesystem::path& file);

// Of two files with the same name, the second would replace the first. Throws CLI::ValidationError. Empty names and
// standard output are left out.
void require_different_names(std::span<const std::filesystem::path> files);

// Throws FileError if the file exists and `force` is false, and always for a folder, a device or a pipe.
void refuse_to_overwrite(const std::filesystem::path& file, bool force);

// Creates the folders above the file. Throws FileError.
void create_folder_of(const std::filesystem::path& file);

// Calls both of the above and opens the file.
OutputFile open_output(const std::filesystem::path& file, bool force);

// Writes the whole file.
void write_file(const std::filesystem::path& file, std::string_view text, bool force);

}  // namespace tumble::tools
