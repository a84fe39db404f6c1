// What `diff` compares: the kind of an input, found by its name and its first bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace tumble::tools {

enum class InputKind : std::uint8_t {
    states,   // a scene, a trajectory, or the folder of a run with trajectory.csv
    hashes,   // as `run --hashes` writes them
    events,   // events.csv
    summary,  // summary.json
    frames    // a folder of PNG files, the folder of a run without trajectory.csv, or one PNG file
};

// Throws FileError for a table that cannot be read.
InputKind kind_of(const std::filesystem::path& path);

// "a list of hashes".
std::string_view name_of(InputKind kind);

// The folder that contains the frames of a run: `folder` itself, or its folder frames.
std::filesystem::path frames_in(const std::filesystem::path& folder);

}  // namespace tumble::tools
