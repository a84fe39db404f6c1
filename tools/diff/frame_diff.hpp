// Compares the frames of two runs pixel by pixel.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tumble/render.hpp"

namespace tumble::tools {

// How two frames of one name differ.
struct FrameDifference {
    std::string frame;       // name of the file
    std::string what;        // of other sizes: "640x360 pixels in A, 320x180 in B"; else empty
    std::size_t pixels = 0;  // that differ by more than the tolerance
    int largest = 0;         // of a channel, 1 to 255, and where:
    int x = 0, y = 0;        // pixels from the upper left corner
};

struct FrameComparison {
    std::size_t frames = 0;           // that both have
    std::size_t differing = 0;        // of them
    std::vector<std::string> only_a;  // names of frames
    std::vector<std::string> only_b;
    std::optional<FrameDifference> first;
    std::optional<FrameDifference> worst;  // the one with the largest number of pixels
    Image heat_map;                        // of the worst; empty if no pixel differs

    bool is_equal() const { return differing == 0 && only_a.empty() && only_b.empty(); }
};

// `a` and `b` are two folders or two PNG files. Two pixels differ if a channel (0 to 255) differs by more than the
// tolerance. Throws FileError or InputError.
FrameComparison compare_frames(const std::filesystem::path& a, const std::filesystem::path& b, double tolerance);

// A frame in dark grey, with each pixel that differs in a colour from yellow (by 1) to red (by 255).
Image make_heat_map(const Image& a, const Image& b, double tolerance);

std::string to_text(const FrameComparison& comparison);
std::string to_json(const FrameComparison& comparison, const std::filesystem::path& heat_map);

}  // namespace tumble::tools
