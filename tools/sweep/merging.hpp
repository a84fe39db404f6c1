// Joins the shards of several folders.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/sweep/sweep_folder.hpp"

namespace tumble::tools {

// Copies the complete shards of `parts` that `folder` does not have, after comparing their checksums, and completes the
// folder if none is missing. Returns the shards that are. Throws FileError, also for parts of another sweep, and
// InputError for a file with a wrong checksum.
ShardRanges merge_folders(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& parts);

}  // namespace tumble::tools
