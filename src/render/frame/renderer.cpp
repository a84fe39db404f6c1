// The renderer: world to draw list, draw list to image.
#include <stdexcept>
#include <string>
#include <utility>

#include "render/canvas/canvas.hpp"
#include "render/canvas/glyph_atlas.hpp"
#include "render/frame/draw_list.hpp"
#include "render/frame/labels.hpp"
#include "render/frame/marking.hpp"
#include "render/frame/overlay.hpp"
#include "tumble/render.hpp"

namespace tumble {

struct Renderer::Impl {
    int width;
    int height;
    render::GlyphAtlas atlas;
    render::Canvas canvas;
    render::DrawList list;
};

namespace {

int checked_side(const char* name, int pixels) {
    if (pixels < kSmallestFrame || pixels > kLargestFrame)
        throw std::invalid_argument(std::string("the ") + name + " of a frame must be " +
                                    std::to_string(kSmallestFrame) + " to " + std::to_string(kLargestFrame) +
                                    " pixels, got " + std::to_string(pixels));
    return pixels;
}

}  // namespace

Renderer::Renderer(int width, int height)
    : impl_(new Impl{checked_side("width", width),
                     checked_side("height", height),
                     render::GlyphAtlas(render::find_font(render::font_candidates())),
                     render::Canvas(render::make_osmesa_context(), width, height),
                     {}}) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(const Scene& scene, const SceneWorld& world, const Camera& camera, double time, Image& image,
                    const Overlay& overlay, const Marking& marking) {
    if (!is_finite(camera.center) || !(camera.height > 0.0) || !std::isfinite(camera.height))
        throw std::invalid_argument("a camera needs a finite center and a height above 0, got (" +
                                    std::to_string(camera.center.x) + ", " + std::to_string(camera.center.y) +
                                    ") and " + std::to_string(camera.height));
    const render::View view = render::make_view(camera, impl_->width, impl_->height);
    render::build_draw_list(impl_->list, scene, world, view);
    render::add_overlay(impl_->list, view, world.world, overlay);
    render::add_marking(impl_->list.overlay, view, world.world, marking);
    const render::LabelText text{scene.name, time, marking.caption, render::legend_of(overlay, world.world)};
    render::add_labels(impl_->list, impl_->atlas, view, text);
    impl_->canvas.draw(impl_->list.background, std::as_const(impl_->list).layers(), impl_->atlas, image);
}

}  // namespace tumble
