// The transform from the world to the pixels of a frame, for programs that read frames.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/output/json_writer.hpp"
#include "tools/run/run_options.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// A point (x, y) of the world is at column width / 2 + pixels_per_metre (x - center.x) and at row
// height / 2 - pixels_per_metre (y - center.y), from the upper left corner of the frame.
struct FrameView {
    std::uint64_t frame = 0;  // the first of those with this view
    DVec2 center;
    double pixels_per_metre = 1.0;
};

FrameView view_of(const Camera& camera, FrameSize size, std::uint64_t frame);

// Appends the view unless it equals the last one.
void add_view(std::vector<FrameView>& views, const FrameView& view);

// An object with the size of the frame, "center" and "pixels_per_metre".
void write_view(JsonWriter& json, FrameSize size, const FrameView& view);

// An object with the size of the frames and, in "from_frame", the views, each with its first frame.
void write_views(JsonWriter& json, FrameSize size, const std::vector<FrameView>& views);

}  // namespace tumble::tools
