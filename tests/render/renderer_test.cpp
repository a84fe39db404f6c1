// Whole frames: the same bytes in every run, readable text, and clear errors.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "render/canvas/glyph_atlas.hpp"
#include "render/hand_made_scene.hpp"
#include "render/pixels.hpp"
#include "render/style/theme.hpp"
#include "tumble/render.hpp"

using namespace tumble;

// OSMesa 22.3 does not free the buffer description (160 bytes) of a context, and EGL's display is never closed. The
// leak checker ignores their allocations.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libEGL\nleak:swrast_dri\nleak:libgallium\n";
}

namespace {

HandMadeScene playground() {
    HandMadeScene s;
    s.scene.name = "playground";
    s.add_static("ground", {0.0, -1.0}, make_box({40.0f, 2.0f}));
    s.add_dynamic("crate", {-2.0, 0.5}, make_box({1.0f, 1.0f}, 0.05f));
    s.add_dynamic("ball", {2.0, 1.0}, make_circle(1.0f), 30.0);
    return s;
}

Image frame(Renderer& renderer, const HandMadeScene& s, double time = 0.5) {
    Image image;
    renderer.draw(s.scene, s.built, {{0.0, 1.0}, 9.0}, time, image);
    return image;
}

}  // namespace

TEST_CASE("a frame shows bodies at their poses, on the background, with opaque pixels") {
    const HandMadeScene s = playground();
    Renderer renderer(640, 360);  // 40 pixels a metre, the world point (0, 1) in the middle
    const Image image = frame(renderer, s);
    REQUIRE(image.width == 640);
    REQUIRE(image.height == 360);
    REQUIRE(image.rgba.size() == 640 * 360 * 4);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) REQUIRE(image.rgba[i] == 255);
    using render::pixel;
    CHECK(pixel(image, 320 - 80, 180 + 20) == render::colors_of(Theme::light).bodies[0]);  // the crate
    CHECK(pixel(image, 320 + 80 - 20, 180 + 10) ==
          render::colors_of(Theme::light).bodies[1]);                                   // the ball, beside its mark
    CHECK(pixel(image, 600, 180 + 60) == render::colors_of(Theme::light).static_fill);  // 0.5 m below the ground's top
}

TEST_CASE("frames repeat byte for byte, in one renderer and in another") {
    const HandMadeScene s = playground();
    Renderer first(640, 360);
    const Image image = frame(first, s);
    CHECK(frame(first, s).rgba == image.rgba);
    Renderer second(640, 360);
    CHECK(frame(second, s).rgba == image.rgba);
    CHECK(frame(first, s, 0.75).rgba != image.rgba);  // the clock is in the frame
    Renderer moved = std::move(second);
    CHECK(frame(moved, s).rgba == image.rgba);
}

TEST_CASE("the island overlay covers bodies and no other mark") {
    HandMadeScene s = playground();
    const BodyId crate = s.built.bodies.at(1).id, ball = s.built.bodies.at(2).id;
    for (const BodyId body : {crate, ball}) s.built.world.set_velocity(body, {4.0f, 0.0f}, 0.0f);
    Renderer renderer(640, 360);
    const auto seen = [&](const Overlay& overlay, int x, int y) {
        Image image;
        renderer.draw(s.scene, s.built, {{0.0, 1.0}, 9.0}, 0.5, image, overlay);
        return render::pixel(image, x, y);
    };
    const Overlay velocity{.velocity = true}, islands{.islands = true}, both{.islands = true, .velocity = true};
    // The displacement in 0.1 s is 16 pixels long. 8 pixels from the middles of crate and ball:
    for (const auto& [x, y] : {std::pair{320 - 80 + 8, 180 + 20}, std::pair{320 + 80 + 8, 180}}) {
        CHECK(seen(both, x, y) == seen(velocity, x, y));
        CHECK(seen(both, x, y) != seen(islands, x, y));
    }
    // Beside the arrow, where the bodies have one colour:
    for (const auto& [x, y] : {std::pair{320 - 80 - 8, 180 + 20 + 8}, std::pair{320 + 80 - 20, 180 + 10}})
        CHECK(seen(both, x, y) == seen(islands, x, y));
}

TEST_CASE("frames of the least and of odd sizes can be drawn, with long and malformed names") {
    HandMadeScene s = playground();
    s.scene.name = std::string(300, 'W') + "\u00e9\xff";
    for (const auto& [width, height] : {std::pair{16, 16}, std::pair{333, 201}, std::pair{240, 135}}) {
        Renderer renderer(width, height);
        CHECK(frame(renderer, s).rgba.size() == static_cast<std::size_t>(4 * width * height));
    }
}

TEST_CASE("sizes and cameras out of range are errors that state the value") {
    CHECK_THROWS_WITH_AS(Renderer(15, 100), "the width of a frame must be 16 to 8192 pixels, got 15",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(Renderer(100, 8193), "the height of a frame must be 16 to 8192 pixels, got 8193",
                         std::invalid_argument);
    const HandMadeScene s = playground();
    Renderer renderer(64, 64);
    Image image;
    CHECK_THROWS_AS(renderer.draw(s.scene, s.built, {{0.0, 0.0}, 0.0}, 0.0, image), std::invalid_argument);
    CHECK_THROWS_AS(renderer.draw(s.scene, s.built, {{0.0, std::nan("")}, 1.0}, 0.0, image), std::invalid_argument);
}

TEST_CASE("title, time, scale bar, grid and notes can be left out, and small frames have no text") {
    HandMadeScene s;
    s.scene.name = "empty";
    s.scene.camera.notes = {{.text = "note", .position = DVec2{0.0, 1.0}}};
    const Camera camera{{0.0, 1.0}, 9.0};
    const auto marked_pixels = [&](int width, int height, const Overlay& overlay) {
        Renderer renderer(width, height);
        Image image;
        renderer.draw(s.scene, s.built, camera, 0.5, image, overlay);
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                count += render::pixel(image, x, y) != render::colors_of(Theme::light).background;
        return count;
    };
    Overlay none;
    for (const OverlayPart& part : kFrameParts) none.*part.member = false;
    CHECK(marked_pixels(640, 360, none) == 0);
    for (const OverlayPart& part : kFrameParts) {
        CAPTURE(part.name);
        Overlay one = none;
        one.*part.member = true;
        CHECK(marked_pixels(640, 360, one) > 0);
        CHECK((marked_pixels(256, 144, one) > 0) == (part.member == &Overlay::grid));
    }
}

TEST_CASE("a missing font is an error that names the package and the files searched") {
    const std::filesystem::path nowhere[] = {"/nowhere/A.ttf", "/nowhere/B.ttf"};
    try {
        render::find_font(nowhere);
        FAIL("no error");
    } catch (const RenderError& error) {
        const std::string message = error.what();
        CHECK(message.find("fonts-dejavu-core") != std::string::npos);
        CHECK(message.find("/nowhere/A.ttf") != std::string::npos);
        CHECK(message.find("/nowhere/B.ttf") != std::string::npos);
    }
    CHECK_THROWS_AS(render::GlyphAtlas(__FILE__), RenderError);
}

TEST_CASE("a world without a scene is drawn with the colours of its types, and fills its frame") {
    World world;
    const BodyId ground = world.create_body({.type = BodyType::static_body, .pose = {{0.0, -1.0}, {}}});
    world.add_shape(ground, {.shape = make_box({40.0f, 2.0f})});
    const BodyId crate = world.create_body({.pose = {{-2.0, 0.5}, {}}});
    world.add_shape(crate, {.shape = make_box({1.0f, 1.0f})});
    const BodyId lift = world.create_body({.type = BodyType::kinematic_body, .pose = {{2.0, 0.5}, {}}});
    world.add_shape(lift, {.shape = make_box({1.0f, 1.0f})});
    Renderer renderer(640, 360);
    Image image;
    renderer.draw(world, {{0.0, 1.0}, 9.0}, image);  // 40 pixels a metre
    using render::pixel;
    CHECK(pixel(image, 320 - 80 - 12, 180 + 30) ==
          render::colors_of(Theme::light).bodies[crate.index % render::colors_of(Theme::light).bodies.size()]);
    CHECK(pixel(image, 320 + 80 - 12, 180 + 30) == render::colors_of(Theme::light).kinematic_fill);
    CHECK(pixel(image, 600, 180 + 60) == render::colors_of(Theme::light).static_fill);

    const Camera camera = make_camera(world, 16.0 / 9.0);
    CHECK(std::abs(camera.center.x) < 0.1);  // the two boxes lie symmetrically
    CHECK(camera.height > 1.0);
    CHECK(camera.height < 10.0);
    const Camera empty = make_camera(World(), 1.0);
    CHECK(empty.height > 0.0);
    renderer.draw(World(), empty, image);
    CHECK_THROWS_AS(renderer.draw(world, {{0.0, 0.0}, 0.0}, image), std::invalid_argument);
}

TEST_CASE("a body that a program adds to the world of a scene is drawn too") {
    HandMadeScene s = playground();
    const BodyId added = s.built.world.create_body({.pose = {{0.0, 3.0}, {}}});
    s.built.world.add_shape(added, {.shape = make_box({1.0f, 1.0f})});
    Renderer renderer(640, 360);
    const Image image = frame(renderer, s);
    CHECK(render::pixel(image, 320 - 12, 180 - 80 + 12) ==
          render::colors_of(Theme::light).bodies[added.index % render::colors_of(Theme::light).bodies.size()]);
    CHECK(render::pixel(image, 320 - 80, 180 + 20) == render::colors_of(Theme::light).bodies[0]);
}
