// Files that are either whole or not there: written to a temporary name in the same folder, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace tumble::render {

// Replaces a file of that name. Throws FileError with the system's reason, after removing the temporary file; what was
// there before then still stands.
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

}  // namespace tumble::render
