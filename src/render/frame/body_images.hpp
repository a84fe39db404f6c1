// The images of bodies: their files, and their place in a frame.
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
    static constexpr std::size_t kMostPixels = 64'000'000;  // of all files

    // The pixels of a file, valid as long as this object; null if there is none. Throws as read_png(), and PictureError
    // if all files have more than kMostPixels.
    const Image* find(const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, std::optional<Image>> files_;
    std::size_t pixels_ = 0;
};

// Adds the images of all bodies to the layers `backdrop` and `images`, in their order: first by `order`, then as the
// bodies. A file that is missing gives the outline of its image.
void add_body_images(DrawList& list, const View& view, const Scene& scene, const SceneWorld& world, ImageFiles& files);

}  // namespace tumble::render
