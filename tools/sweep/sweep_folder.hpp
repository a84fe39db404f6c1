// The folder of a sweep: what is complete in it, what is missing, and how it is completed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "sweep/store/manifest.hpp"

namespace tumble::tools {

// Whether the files of a shard are there with their sizes; its lines of the table may be in runs.csv instead.
bool is_stored(const std::filesystem::path& folder, const sweep::Manifest& manifest, std::uint64_t shard);

// Ranges of shards, both ends included.
using ShardRanges = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
ShardRanges missing_shards(const std::filesystem::path& folder, const sweep::Manifest& manifest);

// The manifest of a folder that has one with its first line: the header is set. Throws FileError.
sweep::Manifest manifest_of_sweep(const std::filesystem::path& folder);

// Whether the shards, runs.csv and the final manifest are there.
bool is_complete(const std::filesystem::path& folder, const sweep::Manifest& manifest);

// Makes runs.csv from the lines of the shards, rewrites the manifest, and removes what only served the work. May be
// repeated after it was interrupted. All shards must be stored. Throws FileError, and InputError for lines with a wrong
// checksum.
void complete_folder(const std::filesystem::path& folder);

}  // namespace tumble::tools
