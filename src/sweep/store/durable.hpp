// Waits until what was written would survive a loss of power.
#pragma once

#include <filesystem>

namespace tumble::sweep {

// The bytes of a file, or the names in a folder (fsync). Throws FileError.
void make_durable(const std::filesystem::path& file_or_folder);

}  // namespace tumble::sweep
