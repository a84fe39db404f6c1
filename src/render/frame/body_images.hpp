// The images of bodies: their files, and their primitives in a frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"
#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Reads each file once, and keeps its pixels.
class ImageFiles {
public:
    static constexpr std::size_t kMostPixels = 64'000'000;  // of a scene

    // The pixels of a file, valid until clear(); null if there is none. Throws FileError if it is no regular file or
    // cannot be read, and PictureError as read_picture(), each time.
    const Image* find(const std::filesystem::path& file);

    // Of all files that are kept.
    std::size_t pixels() const noexcept { return pixels_; }
    void clear();

private:
    std::map<std::filesystem::path, std::optional<Image>> files_;
    std::size_t pixels_ = 0;
};

// Adds the images of all bodies to the layers `backdrop` and `images`, in their order: first by `order`, then as the
// bodies. A file that is missing gives the outline of its image. Throws as ImageFiles::find(), and PictureError if the
// images of the scene have more than kMostPixels.
void add_body_images(DrawList& list, const View& view, const Scene& scene, const SceneWorld& world, ImageFiles& files);

}  // namespace tumble::render
