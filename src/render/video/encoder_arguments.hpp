// The arguments of ffmpeg.
#pragma once

#include <string>
#include <vector>

#include "tumble/recording.hpp"

namespace tumble::render {

// The command line of ffmpeg that reads raw RGBA frames from its standard input and writes `file`.
std::vector<std::string> encoder_arguments(const VideoSettings& settings, const std::string& file);

}  // namespace tumble::render
