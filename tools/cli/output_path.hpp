// Promised files: what is done before they are begun.
#pragma once

#include <filesystem>
#include <string_view>

#include "tumble/file.hpp"

namespace tumble::tools {

// Throws FileError if something is there already and `force` is not given.
void refuse_to_overwrite(const std::filesystem::path& file, bool force);

// Creates the folders above the file. Throws FileError.
void create_folder_of(const std::filesystem::path& file);

// Both of the above, then the file itself.
OutputFile open_output(const std::filesystem::path& file, bool force);

// The same, and all that it shall hold.
void write_file(const std::filesystem::path& file, std::string_view text, bool force);

}  // namespace tumble::tools
