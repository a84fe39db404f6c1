// Creates output files: refuses to overwrite, and creates missing folders.
#pragma once

#include <filesystem>
#include <string_view>

#include "tumble/file.hpp"

namespace tumble::tools {

// Throws FileError if the file exists and `force` is false, and always for a folder, a device or a pipe.
void refuse_to_overwrite(const std::filesystem::path& file, bool force);

// Creates the folders above the file. Throws FileError.
void create_folder_of(const std::filesystem::path& file);

// Calls both of the above and opens the file.
OutputFile open_output(const std::filesystem::path& file, bool force);

// Writes the whole file.
void write_file(const std::filesystem::path& file, std::string_view text, bool force);

}  // namespace tumble::tools
