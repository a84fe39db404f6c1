#include "tools/run/frame_views.hpp"

namespace tumble::tools {

FrameView view_of(const Camera& camera, FrameSize size, std::uint64_t frame) {
    return {frame, camera.center, size.height / camera.height};
}

void add_view(std::vector<FrameView>& views, const FrameView& view) {
    const bool is_same =
        !views.empty() && views.back().center == view.center && views.back().pixels_per_metre == view.pixels_per_metre;
    if (!is_same) views.push_back(view);
}

void write_view(JsonWriter& json, FrameSize size, const FrameView& view) {
    json.open_object().member("width", size.width).member("height", size.height);
    json.member("center", view.center).member("pixels_per_metre", view.pixels_per_metre).close_object();
}

void write_views(JsonWriter& json, FrameSize size, const std::vector<FrameView>& views) {
    json.open_object().member("width", size.width).member("height", size.height).key("from_frame").open_array();
    for (const FrameView& view : views)
        json.open_object()
            .member("frame", view.frame)
            .member("center", view.center)
            .member("pixels_per_metre", view.pixels_per_metre)
            .close_object();
    json.close_array().close_object();
}

}  // namespace tumble::tools
