#include "render/frame/body_images.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/style/style.hpp"

namespace tumble::render {

namespace {

constexpr Color kMissing{120, 128, 140};  // the outline of an image without a file

struct Placed {
    const SceneImage* image = nullptr;
    Pose body;
};

// In the order in which they are drawn.
std::vector<Placed> placed_images(const Scene& scene, const SceneWorld& world) {
    std::vector<Placed> all;
    for (const SceneInstance& body : world.bodies)
        if (world.world.is_valid(body.id))
            for (const SceneImage& image : source_of(scene, body).images)
                all.push_back({&image, world.world.state(body.id).pose});
    std::ranges::stable_sort(all, {}, [](const Placed& placed) { return placed.image->order; });
    return all;
}

}  // namespace

const Image* ImageFiles::find(const std::filesystem::path& file) {
    if (file.empty()) return nullptr;
    const auto [entry, is_new] = files_.try_emplace(file);
    std::error_code ignored;
    if (is_new && std::filesystem::exists(file, ignored)) {
        entry->second = read_png(file);
        pixels_ += entry->second->rgba.size() / 4;
        if (pixels_ > kMostPixels)
            throw PictureError(file.string() + ": the images of the scene have more than " +
                               std::to_string(kMostPixels / 1'000'000) + " million pixels");
    }
    return entry->second ? &*entry->second : nullptr;
}

void add_body_images(DrawList& list, const View& view, const Scene& scene, const SceneWorld& world, ImageFiles& files) {
    for (const auto& [image, body] : placed_images(scene, world)) {
        const Image* const pixels = files.find(image->path);
        const double proportion = pixels ? static_cast<double>(pixels->width) / pixels->height : 1.0;
        const DVec2 half = 0.5 * view.scale * DVec2{image->width.value_or(proportion * image->height), image->height};
        const DVec2 center = view.to_pixels(transform_point(body, image->center));
        if (!view.is_in_view(center, length(half))) continue;
        const double turn = image->angle * (3.14159265358979323846 / 180.0);
        const DVec2 axis = rotate(body.rotation, DVec2{std::cos(turn), std::sin(turn)});
        const auto f = [](double number) { return static_cast<float>(number); };
        Layer& layer = image->order < 0 ? list.backdrop : list.images;
        if (pixels)
            layer.images.push_back({f(center.x), f(center.y), f(axis.x), f(axis.y), f(half.x), f(half.y),
                                    f(image->opacity), image->flip ? -1.0f : 1.0f, pixels});
        else
            layer.boxes.push_back({f(center.x),
                                   f(center.y),
                                   f(axis.x),
                                   f(axis.y),
                                   f(half.x),
                                   f(half.y),
                                   0.0f,
                                   {faded(kMissing, 0.0), kMissing}});
    }
}

}  // namespace tumble::render
