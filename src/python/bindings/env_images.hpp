// Images as observations: what the camera of the scene, or one of their own, sees of each world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "python/bindings/env_plan.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::python {

// The images of n worlds: pixels [n, height, width, 3] of 8 bits, or a mask [n, height, width] of 16 bits.
struct ImageArray {
    std::span<std::uint8_t> pixels;
    std::span<std::uint16_t> labels;
};

class EnvImages {
public:
    // The cameras are those of the initial state.
    EnvImages(const Scene& scene, const SceneWorld& start, const std::vector<ImagePlan>& plans);

    std::size_t count() const { return images_.size(); }

    // The numbers of one world in the array of an image.
    std::size_t size(std::size_t image) const;
    bool is_mask(std::size_t image) const { return images_[image].plan.is_mask; }

    // Draws all images of a copy of the initial world into row `index`. Any thread may call it. Throws RenderError.
    void draw(World& world, const SceneWorld& start, std::span<const ImageArray> arrays, std::size_t index) const;

    // Makes row `index` of all images zero.
    void clear(std::span<const ImageArray> arrays, std::size_t index) const;

private:
    struct View {
        ImagePlan plan;
        Scene scene;  // with the camera of the image
        Camera camera;
    };
    std::vector<View> images_;
};

}  // namespace tumble::python
