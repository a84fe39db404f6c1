#include "render/frame/body_images.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/style/style.hpp"
#include "tumble/file.hpp"

namespace tumble::render {

namespace {

constexpr Color kMissing{120, 128, 140};  // the outline of an image without a file

struct Placed {
    const SceneImage* image = nullptr;
    Pose body;
};

std::size_t pixels_of(const Image& image) { return image.rgba.size() / 4; }

// The images of one frame, each counted once.
class PixelCount {
public:
    // Throws PictureError if all have more than kMostPixels.
    void add(const Image& image, const std::filesystem::path& file) {
        if (!counted_.insert(&image).second) return;
        pixels_ += pixels_of(image);
        if (pixels_ > ImageFiles::kMostPixels)
            throw PictureError(file.string() + ": the images of the scene have more than " +
                               std::to_string(ImageFiles::kMostPixels / 1'000'000) + " million pixels");
    }

private:
    std::set<const Image*> counted_;
    std::size_t pixels_ = 0;
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
    auto entry = files_.find(file);
    if (entry == files_.end()) {
        std::optional<Image> image;
        if (is_file_there(file)) image = read_picture(file);
        if (image) pixels_ += pixels_of(*image);
        entry = files_.emplace(file, std::move(image)).first;
    }
    return entry->second ? &*entry->second : nullptr;
}

void ImageFiles::clear() {
    files_.clear();
    pixels_ = 0;
}

void add_body_images(DrawList& list, const View& view, const Scene& scene, const SceneWorld& world, ImageFiles& files) {
    PixelCount count;
    for (const auto& [image, body] : placed_images(scene, world)) {
        const Image* const pixels = files.find(image->path);
        if (pixels) count.add(*pixels, image->path);
        const double proportion = pixels ? static_cast<double>(pixels->width) / pixels->height : 1.0;
        const DVec2 half = 0.5 * view.scale * DVec2{image->width.value_or(proportion * image->height), image->height};
        const DVec2 center = view.to_pixels(transform_point(body, image->center));
        if (!view.is_in_view(center, length(half))) continue;
        const SinCos turn = sin_cos_degrees(image->angle);
        const DVec2 axis = rotate(body.rotation, DVec2{turn.cos, turn.sin});
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
