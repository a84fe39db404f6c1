// The frames of a comparison: both runs, and below them plots of their distance and energies with the time of the
// frame.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/compare/compared_pictures.hpp"
#include "tools/compare/compared_runs.hpp"
#include "tools/run/video_output.hpp"

namespace tumble::tools {

struct ComparedFrames {
    std::filesystem::path folder;  // of frame_000000.png and so on; empty: none
    std::filesystem::path video;   // empty: none
    double frames_per_second = 30.0;
    PairPictures pictures;
};

// The settings of the video. Throws as video_settings().
VideoSettings compared_video(const ComparedFrames& options);

// Returns the number of frames: 0 if one of the runs is a table. Frame k shows the step nearest to k /
// frames_per_second seconds. An interrupt ends the frames and completes the video. Throws as draw_pairs(),
// require_memory(), FileError.
std::uint64_t write_frames(const CompareInputs& inputs, const ComparedRuns& runs, const ComparedFrames& options);

}  // namespace tumble::tools
