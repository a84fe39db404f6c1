// The folder of a run: frames/frame_000000.png and so on, summary.json, events.csv.
#pragma once

#include <cstdint>
#include <filesystem>

namespace tumble::tools {

// Creates the folder of a run. A folder that is not empty is an error unless `force` is true: then the frames, the
// summary and the events of an earlier run, complete or not, are removed, and no other file. The caller holds the
// folder's lock. Throws FileError.
void prepare_run_folder(const std::filesystem::path& folder, bool with_frames, bool force);

// Removes what an earlier run has not completed in its folder. The caller holds the folder's lock, which shows that no
// process writes these files any more. Throws std::filesystem::filesystem_error.
void remove_partial_files(const std::filesystem::path& folder);

// Removes what processes that were killed have left of this file. Throws std::filesystem::filesystem_error.
void remove_dead_parts_of(const std::filesystem::path& file);

// The name of a table of an interrupted run while another run continues it: t.csv.earlier.
std::filesystem::path earlier_part_of(const std::filesystem::path& file);

// folder/frames/frame_000000.png
std::filesystem::path frame_file(const std::filesystem::path& folder, std::uint64_t frame);

// Whether the file has the name of a frame.
bool is_frame(const std::filesystem::path& file);

std::filesystem::path summary_file(const std::filesystem::path& folder);
std::filesystem::path events_file(const std::filesystem::path& folder);
std::filesystem::path checkpoint_file(const std::filesystem::path& folder);

}  // namespace tumble::tools
