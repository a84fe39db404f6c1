// Colours: parsing, mixing, and the colours of bodies.
#include "render/style/palette.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

#include "render/style/theme.hpp"

using namespace tumble;
using namespace tumble::render;

namespace {

SceneBody body(const char* name, BodyType type, std::vector<SceneShape> shapes) {
    SceneBody body;
    body.name = name;
    body.type = type;
    body.shapes = std::move(shapes);
    return body;
}

SceneShape circle(const char* material = "") { return {CircleGeometry{1.0, {}}, material, ""}; }

Color fill_of(const Palette& palette, std::size_t source, std::size_t ordinal = 0) {
    std::array<Paint, 1> paint;
    palette.paint_body(source, ordinal, paint);
    return paint[0].fill;
}

}  // namespace

TEST_CASE("a colour has three or six hexadecimal digits, and other text is refused") {
    CHECK(parse_color("#9bd") == Color{0x99, 0xbb, 0xdd});
    CHECK(parse_color("#12aBcD") == Color{0x12, 0xab, 0xcd});
    for (const char* wrong : {"", "#", "9bd", "#9b", "#9bdd", "#12345", "#12345g", "#-12", "#1234567"})
        CHECK_FALSE(parse_color(wrong).has_value());
}

TEST_CASE("mixing interpolates between two colours") {
    const Color a{0, 100, 255, 255}, b{255, 200, 0, 55};
    CHECK(mix(a, b, 0.0) == a);
    CHECK(mix(a, b, 1.0) == b);
    CHECK(mix(a, b, 0.5) == Color{128, 150, 128, 155});
}

TEST_CASE("print, high contrast and colour-blind safe colours replace those of materials") {
    Scene scene;
    scene.materials.push_back({.name = "ice", .color = "#123456"});
    scene.bodies = {body("floe", BodyType::static_body, {circle("ice")}),
                    body("ball", BodyType::dynamic_body, {circle("ice")})};
    for (const Theme theme : {Theme::print, Theme::high_contrast, Theme::color_blind}) {
        const Palette palette(scene, colors_of(theme));
        CHECK(fill_of(palette, 0) == colors_of(theme).static_fill);
        CHECK(fill_of(palette, 1) == colors_of(theme).bodies[0]);
    }
    CHECK(fill_of(Palette(scene, colors_of(Theme::dark)), 1) == Color{0x12, 0x34, 0x56});
}

TEST_CASE("the colour of a material overrides the palette, and static bodies are grey") {
    Scene scene;
    scene.materials.push_back({.name = "ice", .color = "#123456"});
    scene.materials.push_back({.name = "plain", .color = ""});
    scene.bodies = {body("ground", BodyType::static_body, {circle()}),
                    body("floe", BodyType::static_body, {circle("ice")}),
                    body("ball", BodyType::dynamic_body, {circle("ice")}),
                    body("stone", BodyType::dynamic_body, {circle("plain")})};
    const Palette palette(scene);
    CHECK(fill_of(palette, 0) == colors_of(Theme::light).static_fill);
    CHECK(fill_of(palette, 1) == Color{0x12, 0x34, 0x56});
    CHECK(fill_of(palette, 2, 5) == Color{0x12, 0x34, 0x56});         // also for the sixth copy: not shaded
    CHECK(fill_of(palette, 3) == colors_of(Theme::light).bodies[1]);  // the second name among dynamic bodies
}

TEST_CASE("names take the palette's colours in turn, and numbered names share one") {
    Scene scene;
    for (const char* name : {"crate", "crate_2", "ball", "", "", "crate[7]"})
        scene.bodies.push_back(body(name, BodyType::dynamic_body, {circle()}));
    scene.timeline.resize(2);  // something else, then two that are spawned: numbered on from the bodies
    scene.timeline.at(1).spawn = body("ball", BodyType::dynamic_body, {circle()});
    scene.timeline.emplace_back().spawn = body("drop", BodyType::dynamic_body, {circle()});
    const Palette palette(scene);
    CHECK(fill_of(palette, 0) == colors_of(Theme::light).bodies[0]);
    CHECK(fill_of(palette, 1) == colors_of(Theme::light).bodies[0]);
    CHECK(fill_of(palette, 2) == colors_of(Theme::light).bodies[1]);
    CHECK(fill_of(palette, 3) == colors_of(Theme::light).bodies[2]);
    CHECK(fill_of(palette, 4) == colors_of(Theme::light).bodies[3]);
    CHECK(fill_of(palette, 5) == colors_of(Theme::light).bodies[0]);
    CHECK(fill_of(palette, 7) == colors_of(Theme::light).bodies[1]);
    CHECK(fill_of(palette, 8) == colors_of(Theme::light).bodies[4]);
}

TEST_CASE("copies of a body differ a little in lightness, the same in every run") {
    Scene scene;
    scene.bodies.push_back(body("crate", BodyType::dynamic_body, {circle()}));
    std::set<int> greens;
    for (std::size_t i = 0; i < 20; ++i) {
        const Color fill = fill_of(Palette(scene), 0, i);
        CHECK(fill == fill_of(Palette(scene), 0, i));
        CHECK(std::abs(fill.g - colors_of(Theme::light).bodies[0].g) <= 20);
        greens.insert(fill.g);
    }
    CHECK(greens.size() >= 6);
}

TEST_CASE("each built shape has the colour of the scene shape that it was built from") {
    Scene scene;
    scene.materials.push_back({.name = "a", .color = "#aa0000"});
    scene.materials.push_back({.name = "b", .color = "#00bb00"});
    scene.materials.push_back({.name = "c", .color = "#0000cc"});
    const std::vector<DVec2> points{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}};
    scene.bodies.push_back(
        body("mixed", BodyType::dynamic_body,
             {{ChainGeometry{points, false, false}, "a", ""}, {OutlineGeometry{points}, "b", ""}, circle("c")}));
    // A chain of four points gives three segments; of six shapes the outline must be two.
    std::array<Paint, 6> paints;
    Palette(scene).paint_body(0, 0, paints);
    const Color a{0xaa, 0, 0}, b{0, 0xbb, 0}, c{0, 0, 0xcc};
    const Color expected[] = {a, a, a, b, b, c};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(paints[i].fill == expected[i]);
        CHECK(paints[i].outline == outline_of(expected[i], colors_of(Theme::light)));
    }
}

TEST_CASE("the same body in several copies of a part has the same colour") {
    Scene scene;
    scene.bodies = {body("left/arm", BodyType::dynamic_body, {circle()}),
                    body("left/hand", BodyType::dynamic_body, {circle()}),
                    body("right/arm", BodyType::dynamic_body, {circle()}),
                    body("right/inner/hand_2", BodyType::dynamic_body, {circle()})};
    const Palette palette(scene);
    CHECK(fill_of(palette, 0) == fill_of(palette, 2));
    CHECK(fill_of(palette, 1) == fill_of(palette, 3));
    CHECK(fill_of(palette, 0) != fill_of(palette, 1));
}
