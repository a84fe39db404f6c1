// Frames as arrays of pixels, and PNG files.
#include "tumble/render.hpp"

#include <cstring>

#include "python/bindings/convert.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/renderers.hpp"
#include "python/bindings/world_box.hpp"

namespace tumble::python {

namespace {

Overlay to_overlay(const std::vector<std::string>& names) {
    Overlay overlay;
    for (const std::string& name : names) {
        bool is_known = false;
        for (const OverlayPart& part : kOverlayParts)
            if (part.name == name) overlay.*part.member = is_known = true;
        if (!is_known) throw std::invalid_argument("there is no overlay '" + name + "'");
    }
    return overlay;
}

py::array_t<std::uint8_t> to_array(const Image& image) {
    py::array_t<std::uint8_t> pixels({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{4}});
    std::memcpy(pixels.mutable_data(), image.rgba.data(), image.rgba.size());
    return pixels;
}

// Of a run: kept from the first frame, and moved with the body that it follows.
Camera fitted_camera(WorldBox& box, bool has_scene, double aspect_ratio) {
    if (!has_scene) return make_camera(box.world(), aspect_ratio);
    WatchedRun& run = box.run();
    const auto kept = run.cameras.find(aspect_ratio);
    if (kept == run.cameras.end())
        return run.cameras.emplace(aspect_ratio, make_camera(run.scene, run.run.built(), aspect_ratio)).first->second;
    return kept->second = move_camera(kept->second, run.scene, run.run.built());
}

py::array_t<std::uint8_t> render(WorldBox& box, bool has_scene, int width, int height, std::optional<Pair> center,
                                 std::optional<double> view_height, const std::vector<std::string>& overlay) {
    Image image;
    Renderer& renderer = tool_of_size<Renderer>(width, height);
    const World& world = box.world();
    const double aspect_ratio = double(width) / double(height);
    Camera camera;
    if (!center || !view_height) camera = fitted_camera(box, has_scene, aspect_ratio);
    if (center) camera.center = to_dvec2(*center);
    if (view_height) camera.height = *view_height;
    if (has_scene)
        renderer.draw(box.run().scene, box.run().run.built(), camera, world.time(), image, to_overlay(overlay));
    else
        renderer.draw(world, camera, image, to_overlay(overlay));
    return to_array(image);
}

using Pixels = py::array_t<std::uint8_t, py::array::c_style>;

void save_png(const Pixels& pixels, const std::string& path) {
    Image image;
    image.height = static_cast<int>(pixels.shape(0));
    image.width = static_cast<int>(pixels.shape(1));
    image.rgba.assign(pixels.data(), pixels.data() + pixels.size());
    write_png(image, path);
}

}  // namespace

void add_render(py::module_& module) {
    module.def("render", render);
    module.def("fitted_camera", [](WorldBox& box, bool has_scene, double aspect_ratio) {
        const Camera camera = fitted_camera(box, has_scene, aspect_ratio);
        return py::make_tuple(to_tuple(camera.center), camera.height);
    });
    module.def("write_png", save_png);
}

}  // namespace tumble::python
