// Whole files: read with a limit, written with every error noticed. All throw FileError.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tumble::scene {

// At most `limit` + 1 bytes, so that the caller sees that there are more.
std::string read_file(const std::filesystem::path& file, std::size_t limit);

// Writes into the file itself, and closes it.
void write_file(const std::filesystem::path& file, std::string_view content);

// Writes a temporary file beside `file`, then renames it: `file` is the old content or the new, never a part.
void replace_file(const std::filesystem::path& file, std::string_view content);

}  // namespace tumble::scene
