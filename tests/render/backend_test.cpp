// The two back ends draw the same frames, and say what they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "render/canvas/glyph_atlas.hpp"
#include "render/hand_made_scene.hpp"
#include "render/pixels.hpp"
#include "render/style/theme.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

TEST_CASE("frames of scenes differ by at most 2 of 255 levels between the back ends") {
    constexpr int kMostLevels = 2;
    Overlay overlay;
    for (const OverlayPart& part : kOverlayParts) overlay.*part.member = true;
    Renderer osmesa(1280, 720, RenderBackend::osmesa), egl(1280, 720, RenderBackend::egl);
    for (const std::string name :
         {"mixed_rain", "wrecking_ball", "bridge", "newton_cradle", "gears", "walker", "soft_blob", "rope_bridge"}) {
        const auto file = std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes" / (name + ".json");
        CAPTURE(file);
        const Scene scene = load_scene(file);
        SceneRun run(scene);
        const Camera camera = make_camera(run.world(), 16.0 / 9.0);
        for (int i = 0; i < 60; ++i) run.step();
        Image a, b;
        osmesa.draw(scene, run.built(), camera, run.time(), a, overlay);
        egl.draw(scene, run.built(), camera, run.time(), b, overlay);
        REQUIRE(a.rgba.size() == b.rgba.size());
        int largest = 0;
        std::size_t differing = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) {
            const int levels = std::abs(a.rgba[i] - b.rgba[i]);
            largest = std::max(largest, levels);
            differing += levels > 0 ? 1u : 0u;
        }
        MESSAGE(name << ": " << differing << " values differ, by at most " << largest);
        CHECK(largest <= kMostLevels);
        CHECK(std::ranges::count(a.rgba, a.rgba[0]) < static_cast<std::ptrdiff_t>(a.rgba.size() / 2));
    }
}

TEST_CASE("a renderer of EGL draws several sizes and images, and repeats its bytes") {
    HandMadeScene s;
    s.add_static("ground", {0.0, -1.0}, make_box({40.0f, 2.0f}));
    s.add_dynamic("ball", {2.0, 1.0}, make_circle(1.0f), 30.0);
    const auto draw = [&](Renderer& renderer) {
        Image image;
        renderer.draw(s.scene, s.built, {{0.0, 1.0}, 9.0}, 0.5, image);
        return image;
    };
    Renderer small(320, 180, RenderBackend::egl), large(640, 360, RenderBackend::egl);
    const Image first = draw(small), other = draw(large);
    CHECK(draw(small).rgba == first.rgba);
    CHECK(draw(large).rgba == other.rgba);
    CHECK(render::pixel(other, 320 + 60, 180 + 10) == render::pixel(first, 160 + 30, 90 + 5));  // the ball
    CHECK(render::pixel(other, 600, 240) == render::colors_of(Theme::light).static_fill);       // 0.5 m below its top
    for (std::size_t i = 3; i < other.rgba.size(); i += 4) REQUIRE(other.rgba[i] == 255);
}

TEST_CASE("each back end draws a triangle and tells what it is") {
    for (const BackendName& backend : kBackends) {
        CAPTURE(backend.name);
        const BackendCheck check = check_backend(backend.backend);
        CHECK(check.works);
        CHECK(check.error == "");
        CHECK(check.version.substr(0, 2) >= "3.");
        CHECK(check.renderer != "");
    }
}

TEST_CASE("a font is needed for text alone") {
    const FontFiles fonts = find_font_files();
    CHECK(std::filesystem::is_regular_file(fonts.text));
    render::GlyphAtlas atlas;  // reads no font
    CHECK(atlas.height() == render::GlyphAtlas::kFirstHeight);
    CHECK(atlas.width("m", 12.0) > 5.0);
}
