// The folder of a run: frames/frame_000000.png and so on, summary.json, events.csv.
#pragma once

#include <cstdint>
#include <filesystem>

namespace tumble::tools {

// Creates the folder of a run. A folder that is not empty is an error unless `force` is true: then the frames, the
// summary and the events of an earlier run are removed, and no other file. Throws FileError.
void prepare_run_folder(const std::filesystem::path& folder, bool with_frames, bool force);

// folder/frames/frame_000000.png
std::filesystem::path frame_file(const std::filesystem::path& folder, std::uint64_t frame);

std::filesystem::path summary_file(const std::filesystem::path& folder);
std::filesystem::path events_file(const std::filesystem::path& folder);

}  // namespace tumble::tools
