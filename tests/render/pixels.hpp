// Draws single primitives, white on black, and measures the pixels.
#pragma once

#include <cstdint>

#include "render/canvas/canvas.hpp"
#include "render/canvas/make_context.hpp"
#include "render/shapes/shape_primitives.hpp"

namespace tumble::render {

inline constexpr Color kWhite{255, 255, 255};
inline constexpr Color kBlack{0, 0, 0};

class PixelCanvas {
public:
    PixelCanvas(int width, int height)
        : width_(width), height_(height), canvas_(make_context(RenderBackend::automatic), width, height) {}

    // A view with `scale` pixels per metre and the origin in the middle.
    View view(double scale) const { return {{}, scale, width_, height_}; }

    // On black, with outlines of 2 pixels.
    Image draw(Layer layer) {
        layer.outline_width = 2.0;
        const Layer* const layers[] = {&layer};
        Image image;
        canvas_.draw(kBlack, layers, atlas_, image);
        return image;
    }

    Image draw_shape(const Shape& shape, const Pose& pose, double scale) {
        Layer layer;
        add_shape(layer, view(scale), shape, pose, flat(kWhite), 3.0);
        return draw(layer);
    }

    GlyphAtlas& atlas() { return atlas_; }

private:
    int width_;
    int height_;
    GlyphAtlas atlas_;
    Canvas canvas_;
};

inline Color pixel(const Image& image, int column, int row) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

// The covered area in pixels: white counts 1, black 0.
inline double coverage(const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i] / 255.0;
    return sum;
}

}  // namespace tumble::render
