// The renderer: world to draw list, draw list to image.
#include <utility>

#include "render/canvas/canvas.hpp"
#include "render/canvas/glyph_atlas.hpp"
#include "render/canvas/make_context.hpp"
#include "render/frame/body_images.hpp"
#include "render/frame/captions.hpp"
#include "render/frame/draw_list.hpp"
#include "render/frame/marking.hpp"
#include "render/frame/notes.hpp"
#include "render/frame/overlay.hpp"
#include "render/view/checked_view.hpp"
#include "tumble/render.hpp"

namespace tumble {

namespace {

render::Look look_of(SceneStyle style, const Overlay& overlay) {
    style.theme = overlay.theme.value_or(style.theme);
    return render::Look(style);
}

}  // namespace

struct Renderer::Impl {
    int width;
    int height;
    render::GlyphAtlas atlas;
    render::ImageFiles images{};  // outlive the canvas, whose textures they are known by
    render::Canvas canvas;
    render::DrawList list;

    // Adds overlay, marking and texts to the draw list, and draws it.
    void finish(const render::View& view, const World& world, render::FrameText text, Image& image,
                const Overlay& overlay, const Marking& marking, const render::Colors& colors) {
        render::add_overlay(list, view, world, overlay, colors);
        render::add_marking(list.overlay, view, world, marking, colors);
        text.legend = render::legend_of(overlay, view, world, colors);
        text.has_title = overlay.title;
        text.has_time = overlay.time;
        text.has_scale_bar = overlay.scale_bar;
        if (!overlay.grid) list.grid.clear();
        render::add_captions(list, atlas, view, text, colors);
        canvas.draw(list.background, std::as_const(list).layers(), atlas, image);
    }
};

Renderer::Renderer(int width, int height, RenderBackend backend)
    : impl_(new Impl{render::checked_side("width", width),
                     render::checked_side("height", height),
                     {},
                     {},
                     render::Canvas(render::make_context(backend), width, height),
                     {}}) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(const Scene& scene, const SceneWorld& world, const Camera& camera, double time, Image& image,
                    const Overlay& overlay, const Marking& marking) {
    const render::View view = render::checked_view(camera, impl_->width, impl_->height);
    const render::Look look = look_of(scene.camera.style, overlay);
    render::build_draw_list(impl_->list, scene, world, view, marking.trails, look);
    if (impl_->images.pixels() > render::ImageFiles::kMostPixels) {  // of scenes that were drawn before, too
        impl_->canvas.forget_images();
        impl_->images.clear();
    }
    render::add_body_images(impl_->list, view, scene, world, impl_->images);
    if (overlay.notes) render::add_notes(impl_->list, impl_->atlas, view, scene.camera, world, time, look.colors);
    impl_->finish(view, world.world, {scene.name, time, marking.caption, {}}, image, overlay, marking, look.colors);
}

void Renderer::draw(const World& world, const Camera& camera, Image& image, const Overlay& overlay,
                    const Marking& marking) {
    const render::View view = render::checked_view(camera, impl_->width, impl_->height);
    const render::Look look = look_of({}, overlay);
    render::build_draw_list(impl_->list, world, view, look);
    impl_->finish(view, world, {"", world.time(), marking.caption, {}}, image, overlay, marking, look.colors);
}

}  // namespace tumble
