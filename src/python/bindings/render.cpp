// Frames as arrays of pixels, PNG files and videos.
#include "tumble/render.hpp"

#include <cmath>
#include <cstring>
#include <mutex>

#include "python/bindings/convert.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/renderers.hpp"
#include "python/bindings/world_box.hpp"
#include "tumble/recording.hpp"
#include "tumble/suggest.hpp"

namespace tumble::python {

namespace {

Theme to_theme(const std::string& name) {
    std::vector<std::string_view> names;
    for (const ThemeName& theme : kThemes) {
        if (theme.name == name) return theme.theme;
        names.push_back(theme.name);
    }
    throw std::invalid_argument("theme must be one of " + join_words(names) + ", got '" + name + "'");
}

Overlay to_overlay(const std::vector<std::string>& names, const std::optional<std::string>& theme) {
    Overlay overlay;
    if (theme) overlay.theme = to_theme(*theme);
    for (const std::string& name : names) {
        bool is_known = false;
        for (const OverlayPart& part : kOverlayParts)
            if (part.name == name) overlay.*part.member = is_known = true;
        if (!is_known) throw std::invalid_argument("there is no overlay '" + name + "'");
    }
    return overlay;
}

py::array_t<std::uint8_t> pixels_of(const Image& image) {
    py::array_t<std::uint8_t> pixels({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{4}});
    std::memcpy(pixels.mutable_data(), image.rgba.data(), image.rgba.size());
    return pixels;
}

// Of a run: kept from the first frame, and moved with the body that it follows.
Camera fitted_camera(WorldBox& box, bool has_scene, double aspect_ratio) {
    if (!has_scene) return make_camera(box.world(), aspect_ratio);
    WatchedRun& run = box.run();
    const auto kept = run.cameras.find(aspect_ratio);
    const SceneWorld& built = run.run.built();
    Camera& camera = kept == run.cameras.end()
                         ? run.cameras.emplace(aspect_ratio, make_camera(run.scene, built, aspect_ratio)).first->second
                         : kept->second = move_camera(kept->second, run.scene, built);
    return apply_camera_keys(camera, run.scene, built, aspect_ratio);
}

py::array_t<std::uint8_t> render(WorldBox& box, bool has_scene, int width, int height, std::optional<Pair> center,
                                 std::optional<double> view_height, const std::vector<std::string>& overlay,
                                 const std::optional<std::string>& theme) {
    Image image;
    Renderer& renderer = tool_of_size<Renderer>(width, height);
    const World& world = box.world();
    const double aspect_ratio = double(width) / double(height);
    Camera camera;
    if (!center || !view_height) camera = fitted_camera(box, has_scene, aspect_ratio);
    if (center) camera.center = to_dvec2(*center);
    if (view_height) camera.height = *view_height;
    const Overlay shown = to_overlay(overlay, theme);
    if (has_scene)
        renderer.draw(box.run().scene, box.run().run.built(), camera, world.time(), image, shown);
    else
        renderer.draw(world, camera, image, shown);
    return pixels_of(image);
}

using Pixels = py::array_t<std::uint8_t, py::array::c_style>;

// Of an array [height, width, 4].
Image to_image(const Pixels& pixels) {
    Image image;
    image.height = static_cast<int>(pixels.shape(0));
    image.width = static_cast<int>(pixels.shape(1));
    image.rgba.assign(pixels.data(), pixels.data() + pixels.size());
    return image;
}

// A video that one thread at a time writes, without the GIL, as ffmpeg may have to be waited for.
class VideoBox {
public:
    VideoBox(const std::string& path, int width, int height, double frames_per_second)
        : writer_(path, checked({format_of(path), width, height, frames_per_second})) {}

    void write(const Pixels& pixels) {
        const Image image = to_image(pixels);
        exclusively([&] { writer_.write(image); });
    }
    std::uint64_t finish() {
        std::uint64_t bytes = 0;
        exclusively([&] { bytes = writer_.finish(); });
        return bytes;
    }

    static VideoFormat format_of(const std::string& path) {
        if (const auto format = video_format_of(path)) return *format;
        throw std::invalid_argument("a video is an .mp4, .webm, .gif or .apng, got '" + path + "'");
    }

private:
    static VideoSettings checked(const VideoSettings& settings) {
        const bool needs_even = settings.format == VideoFormat::mp4 || settings.format == VideoFormat::webm;
        if (settings.width < 1 || settings.height < 1 || (needs_even && (settings.width | settings.height) % 2 != 0))
            throw std::invalid_argument("frames of " + std::to_string(settings.width) + "x" +
                                        std::to_string(settings.height) +
                                        " cannot be a video: mp4 and webm need an "
                                        "even size");
        if (!(settings.frames_per_second > 0.0 && settings.frames_per_second <= 1000.0))
            throw std::invalid_argument("fps must be above 0 and at most 1000, got " +
                                        std::to_string(settings.frames_per_second));
        return settings;
    }

    template <class Call>
    void exclusively(Call&& call) {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock) throw InUse("another thread is writing this video");
        const py::gil_scoped_release release;
        call();
    }

    VideoWriter writer_;
    std::mutex mutex_;
};

}  // namespace

void add_render(py::module_& module) {
    module.def("render", render);
    module.def("fitted_camera", [](WorldBox& box, bool has_scene, double aspect_ratio) {
        if (!std::isfinite(aspect_ratio) || aspect_ratio <= 0.0)
            throw std::invalid_argument("aspect_ratio must be finite and above 0, got " + std::to_string(aspect_ratio));
        const Camera camera = fitted_camera(box, has_scene, aspect_ratio);
        return py::make_tuple(to_tuple(camera.center), camera.height);
    });
    module.def("write_png", [](const Pixels& pixels, const std::string& path) { write_png(to_image(pixels), path); });
    module.def("require_video_name", [](const std::string& path) { VideoBox::format_of(path); });
    py::class_<VideoBox>(module, "VideoWriter")
        .def(py::init<const std::string&, int, int, double>())
        .def("write", &VideoBox::write)
        .def("finish", &VideoBox::finish);
}

}  // namespace tumble::python
