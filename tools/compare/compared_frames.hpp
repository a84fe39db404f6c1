// The frames of a comparison: both runs, and below them a plot of their distance with the time of the frame.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/compare/compared_pictures.hpp"
#include "tools/compare/compared_runs.hpp"

namespace tumble::tools {

struct ComparedFrames {
    std::filesystem::path folder;  // of frame_000000.png and so on
    double frames_per_second = 30.0;
    PairPictures pictures;
};

// Returns the number of frames: 0 if one of the runs is a table. Frame k shows the step nearest to k /
// frames_per_second seconds. Throws as draw_pairs(), FileError.
std::uint64_t write_frames(const CompareInputs& inputs, const ComparedRuns& runs, const ComparedFrames& options);

}  // namespace tumble::tools
