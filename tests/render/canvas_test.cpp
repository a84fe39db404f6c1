// The canvas: colours at known pixels, covered areas against the exact ones, orientation of the frame, repeatability.
#include "render/canvas/canvas.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "render/pixels.hpp"
#include "render/style/style.hpp"
#include "support/near.hpp"
#include "tumble/shape.hpp"

using namespace tumble;
using namespace tumble::render;
using namespace tumble::test;

namespace {

constexpr Color kRed{200, 30, 20};
constexpr Color kBlue{10, 20, 120};

std::vector<Vec2> regular_polygon(int count, float radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const SinCos direction = sin_cos(2.0 * kPi * i / count + 0.1);
        points.push_back({radius * static_cast<float>(direction.cos), radius * static_cast<float>(direction.sin)});
    }
    return points;
}

// Half a pixel on either side of the edge is blended linearly. Along a smooth closed edge the covered area is off by at
// most pi / 12 of a pixel, at a right corner by 1 / 12, at sharper ones by a little more. Each blended pixel is rounded
// by at most 1/510, without bias. For the shapes below, of 4000 pixels and more, that is well within 0.05 %.
constexpr double kAreaTolerance = 0.0005;

void check_area(PixelCanvas& canvas, const Shape& shape, double scale) {
    const double exact = mass_properties(shape).area * scale * scale;
    REQUIRE(exact > 4000.0);
    for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
        const Pose pose{{0.0131, -0.0077}, make_rotation(angle)};
        const double drawn = coverage(canvas.draw_shape(shape, pose, scale));
        CHECK_MESSAGE(std::abs(drawn - exact) <= kAreaTolerance * exact,
                      "angle " << angle << ": " << drawn << " pixels instead of " << exact);
    }
}

}  // namespace

TEST_CASE("a circle has its fill inside, its outline at the edge and the background outside") {
    PixelCanvas canvas(101, 81);  // the middle of pixel (50, 40) is the middle of the frame
    Layer layer;
    layer.circles.push_back({0.0f, 0.0f, 30.0f, {kRed, kBlue}});
    const Image image = canvas.draw(layer);
    CHECK(pixel(image, 50, 40) == kRed);
    CHECK(pixel(image, 50, 13) == kRed);   // 27 up: beyond the outline of 2 pixels
    CHECK(pixel(image, 50, 11) == kBlue);  // 29 up: in the middle of the outline, from 28 to 30
    CHECK(pixel(image, 50, 9) == kBlack);  // 31 up
    CHECK(pixel(image, 79, 40) == kBlue);
    CHECK(pixel(image, 81, 40) == kBlack);
    CHECK(pixel(image, 0, 0) == kBlack);
}

TEST_CASE("the top row of an image is the top of the world and its left column the left") {
    PixelCanvas canvas(64, 32);
    const auto bright = [&](DVec2 at, int column, int row) {
        const Image image = canvas.draw_shape(make_box({2.0f, 2.0f}), {at, {}}, 1.0);
        return pixel(image, column, row) == kWhite && coverage(image) == 4.0;
    };
    CHECK(bright({-31.0, 15.0}, 0, 0));
    CHECK(bright({31.0, 15.0}, 63, 0));
    CHECK(bright({-31.0, -15.0}, 0, 31));
}

TEST_CASE("a shape turns counter-clockwise") {
    PixelCanvas canvas(65, 65);
    // From the middle along +x, turned by 90 degrees: along +y, upwards.
    const Shape arm = make_capsule({5.0f, 0.0f}, {20.0f, 0.0f}, 3.0f);
    const Image image = canvas.draw_shape(arm, {{}, make_rotation_degrees(90.0)}, 1.0);
    CHECK(pixel(image, 32, 32 - 12) == kWhite);
    CHECK(pixel(image, 32, 32 + 12) == kBlack);
    CHECK(pixel(image, 32 + 12, 32) == kBlack);
}

TEST_CASE("the area covered by each kind of primitive is the exact area") {
    PixelCanvas canvas(200, 200);
    SUBCASE("circle") { check_area(canvas, make_circle(1.0f), 60.0); }
    SUBCASE("capsule") { check_area(canvas, make_capsule({-0.5f, 0.0f}, {0.5f, 0.2f}, 0.4f), 80.0); }
    SUBCASE("box") { check_area(canvas, make_box({1.0f, 0.5f}), 90.0); }
    SUBCASE("rounded box") { check_area(canvas, make_box({1.0f, 0.7f}, 0.2f), 90.0); }
    SUBCASE("triangle") { check_area(canvas, make_polygon(regular_polygon(3, 0.9f)), 90.0); }
    SUBCASE("octagon") { check_area(canvas, make_polygon(regular_polygon(8, 0.9f)), 90.0); }
    SUBCASE("rounded pentagon") { check_area(canvas, make_polygon(regular_polygon(5, 0.6f), 0.25f), 90.0); }
    SUBCASE("30-gon") { check_area(canvas, make_polygon(regular_polygon(30, 0.9f)), 90.0); }
    SUBCASE("rounded 12-gon") { check_area(canvas, make_polygon(regular_polygon(12, 0.6f), 0.3f), 90.0); }
    SUBCASE("1000-gon") { check_area(canvas, make_polygon(regular_polygon(1000, 0.9f)), 90.0); }
}

TEST_CASE("a segment is a line of constant width whatever the scale") {
    PixelCanvas canvas(200, 100);
    for (const double scale : {1.0, 10.0, 1000.0}) {
        const float reach = static_cast<float>(50.0 / scale);
        const double drawn = coverage(canvas.draw_shape(make_segment({-reach, 0.0f}, {reach, 0.0f}), {}, scale));
        const double exact = 100.0 * 3.0 + kPi * 1.5 * 1.5;  // 3 pixels wide, with round ends
        // Two round ends, each within pi / 12 of a pixel, and 200 pixels of edge, each rounded by 1/510 at most.
        CHECK(near(drawn, exact, absolute(2.0 * kPi / 12.0 + 200.0 / 510.0)));
    }
}

TEST_CASE("ten kilometres from the origin a frame is the same to the last bit") {
    PixelCanvas canvas(120, 120);
    const Shape shape = make_polygon(regular_polygon(5, 0.5f), 0.1f);
    const auto draw_at = [&](DVec2 origin) {
        View view = canvas.view(100.0);
        view.center = origin;
        Layer layer;
        add_shape(layer, view, shape, {origin + DVec2{0.0625, -0.03125}, make_rotation(0.4)}, {kRed, kBlue}, 3.0);
        return canvas.draw(layer).rgba;
    };
    // Binary fractions of a metre: the sums above are exact in double, even at 2^14 m.
    CHECK(draw_at({}) == draw_at({16384.0, -16384.0}));
}

TEST_CASE("a shape far larger than the frame has a sharp edge at the right pixels") {
    PixelCanvas canvas(100, 80);
    for (const float half : {1e4f, 3e6f}) {  // at 10 pixels per metre: an instance, and a clipped mesh
        const Shape ground = make_box({2.0f * half, 2.0f * half});
        const double top = 0.5;  // 5 pixels above the middle: rows 35 to 79 are covered
        const Image image = canvas.draw_shape(ground, {{0.0, top - half}, {}}, 10.0);
        CHECK(coverage(image) == 100.0 * 45.0);
        CHECK(pixel(image, 50, 33) == kBlack);
        CHECK(pixel(image, 50, 37) == kWhite);
    }
}

TEST_CASE("the same layer gives the same bytes, in one context and in two") {
    Layer layer;
    for (int i = 0; i < 50; ++i) {
        const float x = static_cast<float>(i * 3 - 75), angle = 0.1f * static_cast<float>(i);
        layer.circles.push_back({x, 10.3f, 7.7f, {kRed, kBlue}});
        layer.boxes.push_back({x, -14.2f, std::cos(angle), std::sin(angle), 8.1f, 3.3f, 1.0f, {kBlue, kRed}});
    }
    PixelCanvas canvas(160, 90);
    const std::vector<std::uint8_t> first = canvas.draw(layer).rgba;
    CHECK(canvas.draw(layer).rgba == first);
    PixelCanvas other(160, 90);
    CHECK(other.draw(layer).rgba == first);
    CHECK(canvas.draw(layer).rgba == first);  // although another context was current in between
}

TEST_CASE("text has its colour and position, and the same pixels wherever its glyphs lie in the atlas") {
    PixelCanvas canvas(160, 60);
    const auto draw_text = [&](std::string_view text) {
        Layer layer;
        canvas.atlas().layout(text, 24.0, 10.0, 40, 160, 60, kWhite, layer.glyphs);
        return canvas.draw(layer);
    };
    const Image first = draw_text("Ig");
    // The stem of the I is 2.4 pixels wide at this size, near its left side. The columns left of the start stay black.
    double stem = 0.0;
    for (int column = 10; column < 17; ++column) stem += pixel(first, column, 30).r / 255.0;
    CHECK(stem > 1.5);
    CHECK(stem < 3.5);
    for (int row = 0; row < 60; ++row) CHECK(pixel(first, 8, row) == kBlack);
    CHECK(pixel(first, 13, 45) == kBlack);  // the I ends at the baseline
    draw_text("other glyphs between");      // moves the next ones elsewhere in the atlas
    CHECK(draw_text("Ig").rgba == first.rgba);
    PixelCanvas other(160, 60);
    Layer layer;
    other.atlas().layout("gI", 24.0, 300.0, 40, 160, 60, kWhite, layer.glyphs);
    layer.glyphs.clear();
    other.atlas().layout("Ig", 24.0, 10.0, 40, 160, 60, kWhite, layer.glyphs);
    CHECK(other.draw(layer).rgba == first.rgba);
}

TEST_CASE("the atlas of glyphs grows until it holds all letters of a text, however large they are") {
    std::string letters;
    for (char c = 'A'; c <= 'Z'; ++c) letters += std::string{c, static_cast<char>(c + 'a' - 'A')};
    GlyphAtlas atlas;
    Layer layer;
    for (const double size : {16.0, 96.0, 192.0})  // of labels, and of titles at 2160 and at 4320 rows
        atlas.layout(letters, size, 10.0, 200, 7680, 4320, kWhite, layer.glyphs);
    CHECK(layer.glyphs.size() == 3 * 52);
    CHECK(atlas.height() > GlyphAtlas::kFirstHeight);
    for (const GlyphInstance& glyph : layer.glyphs) {
        CHECK(glyph.atlas_x + glyph.width <= GlyphAtlas::kWidth);
        CHECK(glyph.atlas_y + glyph.height <= static_cast<float>(atlas.height()));
    }
    layer.glyphs.clear();
    atlas.layout("A", 4000.0, 10.0, 200, 7680, 4320, kWhite, layer.glyphs);  // wider than the atlas
    CHECK(layer.glyphs.empty());
}

TEST_CASE("a character that no font has is a box, and signs without a shape take no room") {
    const std::filesystem::path font = find_font(font_candidates());
    GlyphAtlas atlas(font, {});
    const double plain = atlas.width("chain", 12.0), box = atlas.width("\U0001F9F2", 12.0);  // a magnet
    CHECK(box > 3.0);
    CHECK(atlas.width("\u4e2d", 12.0) == box);
    CHECK(near(atlas.width("\U0001F9F2chain\U0001FAE0", 12.0), plain + 2.0 * box, relative(1e-9)));
    CHECK(atlas.width("ch\u200dain\ufe0f", 12.0) == plain);
    Layer layer;
    atlas.layout("\u4e2d", 24.0, 10.0, 40, 160, 60, kWhite, layer.glyphs);
    CHECK(layer.glyphs.size() == 1);
}

TEST_CASE("characters that the font lacks come from the first wide font that can be read") {
    const std::filesystem::path sans = find_font(font_candidates());
    const std::filesystem::path mono = sans.parent_path() / "DejaVuSansMono.ttf";
    REQUIRE(std::filesystem::exists(mono));
    const std::filesystem::path wide[] = {"/no/such/font.ttf", __FILE__, sans};
    GlyphAtlas alone(mono, {}), with_wide(mono, wide), own(sans, {});
    const char* const alef = "\u05d0";  // Hebrew, which the fixed-width font lacks
    CHECK(alone.width(alef, 12.0) == alone.width("\u4e2d", 12.0));
    CHECK(with_wide.width(alef, 12.0) == own.width(alef, 12.0));
    CHECK(with_wide.width(alef, 12.0) != alone.width(alef, 12.0));
    CHECK(with_wide.width("chain", 12.0) == alone.width("chain", 12.0));
}
