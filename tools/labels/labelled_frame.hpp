// What the files of labels say of a frame.
#pragma once

#include <cstdint>
#include <string>

#include "tools/output/json_writer.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

struct LabelledFrame {
    std::uint64_t frame = 0;
    std::uint64_t step = 0;
    double time = 0.0;  // s
    Camera camera;
    int width = 0, height = 0;  // pixels
    std::string image;          // path of the PNG file in the folder of the run, also if it is not written
    std::string mask;
};

// The point (x, y) of the world is at column and row `matrix` (x, y, 1) from the upper left corner.
inline void write_matrix(JsonWriter& json, const LabelledFrame& frame) {
    const double scale = frame.height / frame.camera.height;
    json.key("world_to_pixels").open_array().open_array();
    json.value(scale).value(0.0).value(0.5 * frame.width - scale * frame.camera.center.x).close_array();
    json.open_array();
    json.value(0.0).value(-scale).value(0.5 * frame.height + scale * frame.camera.center.y).close_array();
    json.close_array();
}

// step, time, mask, world_to_pixels
inline void write_frame_members(JsonWriter& json, const LabelledFrame& frame) {
    json.member("step", frame.step).member("time", frame.time);
    if (!frame.mask.empty()) json.member("mask", frame.mask);
    write_matrix(json, frame);
}

}  // namespace tumble::tools
