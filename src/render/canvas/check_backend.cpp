// What works on this machine: each back end draws one triangle.
#include <cstddef>
#include <string>
#include <system_error>

#include "render/canvas/canvas.hpp"
#include "render/canvas/make_context.hpp"
#include "tumble/render.hpp"

namespace tumble {
namespace {

constexpr int kSide = 64;  // pixels
constexpr Color kPaper{255, 255, 255}, kTriangle{200, 60, 20};

// The lower left half of the frame.
render::Layer triangle() {
    render::Layer layer;
    constexpr float kHalf = 0.5f * kSide, kInside = -1e3f;
    const float corners[3][2] = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {-kHalf, kHalf}};
    for (const auto& [x, y] : corners) layer.mesh.push_back({x, y, kInside, render::flat(kTriangle)});
    return layer;
}

bool is_color(const Image& image, int column, int row, Color color) {
    const std::uint8_t* const at = image.rgba.data() + std::ptrdiff_t{4} * (row * kSide + column);
    return at[0] == color.r && at[1] == color.g && at[2] == color.b && at[3] == 255;
}

std::string first_of(std::span<const std::filesystem::path> files) {
    std::error_code ignored;
    for (const std::filesystem::path& file : files)
        if (std::filesystem::is_regular_file(file, ignored)) return file.string();
    return {};
}

}  // namespace

BackendCheck check_backend(RenderBackend backend) {
    BackendCheck check;
    try {
        render::Canvas canvas(render::make_context(backend), kSide, kSide);
        check.version = canvas.version();
        check.renderer = canvas.renderer();
        const render::Layer layer = triangle();
        const render::Layer* const layers[] = {&layer};
        Image image;
        canvas.draw(kPaper, layers, render::GlyphAtlas(), image);
        check.works =
            is_color(image, kSide / 4, 3 * kSide / 4, kTriangle) && is_color(image, 3 * kSide / 4, kSide / 4, kPaper);
        if (!check.works) check.error = "a triangle has the wrong pixels";
    } catch (const RenderError& error) {
        check.error = error.what();
    }
    return check;
}

FontFiles find_font_files() { return {first_of(render::font_candidates()), first_of(render::wide_font_candidates())}; }

}  // namespace tumble
