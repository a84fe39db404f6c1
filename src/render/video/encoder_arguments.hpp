// The arguments of ffmpeg.
#pragma once

#include <string>
#include <vector>

#include "tumble/recording.hpp"

namespace tumble::render {

// The command line of ffmpeg that reads raw RGBA frames from its standard input and writes `file`, or its standard
// output if `file` is empty: an MP4 is then a series of fragments, since ffmpeg cannot go back to write its index.
std::vector<std::string> encoder_arguments(const VideoSettings& settings, const std::string& file);

}  // namespace tumble::render
