// The folder that a run writes into: frames/frame_000000.png and on, summary.json.
#pragma once

#include <cstdint>
#include <filesystem>

namespace tumble::tools {

// Makes the folder ready for a run. A folder that holds anything is refused, unless `force` is given: then the frames
// and the summary of an earlier run are removed, and nothing else. Throws FileError.
void prepare_run_folder(const std::filesystem::path& folder, bool with_frames, bool force);

// folder/frames/frame_000000.png
std::filesystem::path frame_file(const std::filesystem::path& folder, std::uint64_t frame);

std::filesystem::path summary_file(const std::filesystem::path& folder);
std::filesystem::path events_file(const std::filesystem::path& folder);

}  // namespace tumble::tools
