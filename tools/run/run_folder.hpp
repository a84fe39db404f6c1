// The folder of a run: frames/frame_000000.png and so on, summary.json, events.csv; masks/mask_000000.png and so on,
// labels.json, boxes.json.
#pragma once

#include <cstdint>
#include <filesystem>

namespace tumble::tools {

// Throws FileError for a folder that is not empty, unless `force` is true.
void refuse_used_folder(const std::filesystem::path& folder, bool force);

// Removes the frames, the summary, the events, the labels and the checkpoint of an earlier run, complete or not, and no
// other file; creates the folders of a new one. The caller holds the folder's lock. Throws FileError, and
// std::filesystem::filesystem_error for a file that cannot be removed.
void clear_run_folder(const std::filesystem::path& folder, bool with_frames, bool with_masks);

// Removes what an earlier run has not completed in its folder. The caller holds the folder's lock, which shows that no
// process writes these files any more. Throws std::filesystem::filesystem_error.
void remove_partial_files(const std::filesystem::path& folder);

// Removes what processes that were killed have left of this file. Throws std::filesystem::filesystem_error.
void remove_dead_parts_of(const std::filesystem::path& file);

// The name of a table of an interrupted run while another run continues it: t.csv.earlier.
std::filesystem::path earlier_part_of(const std::filesystem::path& file);

// folder/frames/frame_000000.png
std::filesystem::path frame_file(const std::filesystem::path& folder, std::uint64_t frame);

// Whether the file has the name of a frame, of a mask.
bool is_frame(const std::filesystem::path& file);
bool is_mask(const std::filesystem::path& file);

// folder/masks/mask_000000.png
std::filesystem::path mask_file(const std::filesystem::path& folder, std::uint64_t frame);

std::filesystem::path summary_file(const std::filesystem::path& folder);
std::filesystem::path events_file(const std::filesystem::path& folder);
std::filesystem::path checkpoint_file(const std::filesystem::path& folder);
std::filesystem::path labels_file(const std::filesystem::path& folder);
std::filesystem::path boxes_file(const std::filesystem::path& folder);

}  // namespace tumble::tools
