// Drawings: the page and its units, areas with holes, labels, colours and opacity.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "drawings.hpp"
#include "support/near.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::test;

TEST_CASE("holes stay holes, by both fill rules") {
    const std::string outer = "M0 0H30V30H0Z", same = "M10 10H20V20H10Z", opposite = "M10 10V20H20V10Z",
                      island = "M13 13H17V17H13Z";
    const auto body_of = [](const std::string& data, const std::string& rule) {
        const ImportedScene imported = import_text("<path fill-rule='" + rule + "' d='" + data + "'/>");
        const bool is_joined = rule == "nonzero" && data.ends_with("M10 10H20V20H10Z");
        CHECK(notes_of(imported) == (is_joined ? std::map<std::string, int>{{"areas within areas, which are joined", 1}}
                                               : std::map<std::string, int>{}));
        return imported.scene.bodies.at(0);
    };
    // In m^2: 0.09 of the square, 0.01 of the hole, 0.0016 of the island in it.
    CHECK(near(area_of(body_of(outer + same, "evenodd")), 0.08, kFloat));
    CHECK(near(area_of(body_of(outer + opposite, "evenodd")), 0.08, kFloat));
    CHECK(near(area_of(body_of(outer + same, "nonzero")), 0.09, kFloat));
    CHECK(near(area_of(body_of(outer + opposite, "nonzero")), 0.08, kFloat));
    CHECK(near(area_of(body_of(outer + opposite + island, "nonzero")), 0.0816, kFloat));
    CHECK(near(area_of(body_of(outer + same + island, "evenodd")), 0.0816, kFloat));
    const ImportedScene apart = import_text("<path d='M0 0H10V10H0Z M20 0H30V10H20Z'/>");
    CHECK(apart.scene.bodies.at(0).shapes.size() == 2);
    CHECK(apart.notes.empty());
}

TEST_CASE("no shape of an area with holes covers a hole") {
    // A disc of radius 40 with 12 round holes of radius 4 on a circle of radius 28, and one of radius 8 in the middle.
    const auto circle = [](double x, double y, double r, int sweep) {
        const std::string radius = std::to_string(r), turn = " 0 1 " + std::to_string(sweep) + " ";
        return "M" + std::to_string(x - r) + " " + std::to_string(y) + "a" + radius + " " + radius + turn +
               std::to_string(2.0 * r) + " 0a" + radius + " " + radius + turn + std::to_string(-2.0 * r) + " 0Z";
    };
    std::string data = circle(50, 50, 40, 1) + circle(50, 50, 8, 0);
    std::vector<DVec2> holes{{0.5, 0.5}};
    for (int i = 0; i < 12; ++i) {
        const double turn = kPi * i / 6.0, x = 50.0 + 28.0 * std::cos(turn), y = 50.0 + 28.0 * std::sin(turn);
        data += circle(x, y, 4, 0);
        holes.push_back({0.01 * x, 0.01 * (100.0 - y)});
    }
    SvgOptions fine;
    fine.tolerance = 1e-4;
    const ImportedScene imported = import_text("<path d='" + data + "'/>", fine);
    CHECK(imported.notes.empty());
    // pi (0.4^2 - 0.08^2 - 12 x 0.04^2) m^2, chords within 0.1 mm of 6 m of arcs.
    CHECK(std::abs(area_of(imported.scene.bodies.at(0)) - kPi * (0.16 - 0.0064 - 0.0192)) < 1e-4 * 6.0);
    const SceneWorld built = build_world(imported.scene);
    const auto is_covered = [&](DVec2 point) {
        bool found = false;
        for (const ShapeId shape : built.world.shapes(built.bodies[0].id))
            found = found || distance(make_circle(1e-4f), Pose{point, {}}, built.world.shape(shape),
                                      built.world.state(built.bodies[0].id).pose)
                                     .distance < 0.0;
        return found;
    };
    for (const DVec2 hole : holes) CHECK_FALSE(is_covered(hole));
    CHECK(is_covered({0.5, 0.65}));
}

TEST_CASE("a page has the same size in any unit, and its viewBox states what a unit is") {
    // A rectangle of half the page, 96 x 48 px.
    const auto half = [](const std::string& page) {
        const ImportedScene imported = parse_svg("<svg " + page, "page.svg");
        REQUIRE(imported.scene.bodies.size() == 1);
        return only_shape<BoxGeometry>(imported.scene.bodies[0]).size;
    };
    for (const char* page :
         {"width='96' height='48'><rect width='48' height='24'/></svg>",
          "viewBox='0 0 96 48'><rect width='48' height='24'/></svg>",
          "width='1in' height='0.5in'><rect width='48' height='24'/></svg>",
          "width='25.4mm' height='12.7mm' viewBox='0 0 25.4 12.7'><rect width='12.7' height='6.35'/></svg>",
          "width='2.54cm' viewBox='0 0 10 5'><rect width='5' height='2.5'/></svg>",
          "width='96' height='480' viewBox='0 0 2 1'><rect width='1' height='0.5'/></svg>",
          "width='100%' viewBox='0 0 96 48'><rect width='48' height='24'/></svg>"}) {
        CAPTURE(std::string(page));
        CHECK(near(half(page), {0.48, 0.24}, 1e-9));
    }
    const ImportedScene stretched = parse_svg(
        "<svg width='96' height='480' viewBox='0 0 2 1' preserveAspectRatio='none'><rect width='1' "
        "height='0.5'/></svg>",
        "stretched.svg");
    CHECK(near(area_of(stretched.scene.bodies.at(0)), 0.48 * 2.4, kFloat));
    // A4: 210 mm are 793.7 px.
    const ImportedScene a4 = parse_svg(
        "<svg width='210mm' height='297mm' viewBox='0 0 210 297'><rect y='287' width='210' height='10'/></svg>",
        "a4.svg");
    CHECK(near(a4.scene.bodies.at(0).position, {0.5 * 2.1 * 96 / 25.4, 0.05 * 96 / 25.4}, 1e-9));
}

TEST_CASE("a label is the name of a body, and states its type") {
    const ImportedScene imported = import_text(
        "<rect id='rect1' inkscape:label='crate' width='9' height='9'/><g inkscape:label='static layer'>"
        "<rect id='rect2' x='20' inkscape:label=' ' width='9' height='9'/></g>"
        "<rect inkscape:label='crate' x='40' width='9' height='9'/>");
    REQUIRE(imported.scene.bodies.size() == 3);
    CHECK(imported.scene.bodies[0].name == "crate");
    CHECK(imported.scene.bodies[0].type == BodyType::dynamic_body);
    CHECK(imported.scene.bodies[1].name == "rect2");
    CHECK(imported.scene.bodies[1].type == BodyType::static_body);
    CHECK(imported.scene.bodies[2].name == "crate-2");
}

TEST_CASE("colours in any notation, opaque or as they look on white paper") {
    const auto color_of = [](const std::string& style) {
        const ImportedScene imported = import_text("<rect width='9' height='9' style='" + style + "'/>");
        return imported.scene.bodies.empty() ? "hidden" : imported.scene.bodies[0].shapes.at(0).material;
    };
    CHECK(color_of("fill: hsl(120, 100%, 25%)") == "#008000");
    CHECK(color_of("fill: hsl(210deg 50% 40%)") == "#336699");
    CHECK(color_of("fill: hsl(-0.5turn, 100%, 50%)") == "#00ffff");
    CHECK(color_of("fill: hsl(0, 0%, 60%)") == "#999999");
    // Half of red and half of white: (255, 127.5, 127.5).
    for (const char* half :
         {"fill: rgba(255, 0, 0, 0.5)", "fill: rgb(255 0 0 / 50%)", "fill: hsla(0, 100%, 50%, 0.5)",
          "fill: red; fill-opacity: 0.5", "fill: red; opacity: 50%", "fill: rgb(255 0 0 / 0.8); opacity: 0.625"})
        CHECK_MESSAGE(color_of(half) == "#ff8080", std::string(half));
    CHECK(color_of("fill: #ff000080") == "#ff7f7f");  // 128 / 255 is more than a half
    CHECK(color_of("fill: #f000") == "hidden");
    CHECK(color_of("fill: red; opacity: 0") == "hidden");
    CHECK(color_of("fill: red; opacity: much") == "#ff0000");
    const ImportedScene group = import_text("<g opacity='0.5'><g opacity='.5'><rect width='9' height='9'/></g></g>");
    CHECK(group.scene.bodies.at(0).shapes.at(0).material == "#bfbfbf");  // a quarter of black
    CHECK(notes_of(group) == std::map<std::string, int>{{"transparent colours, made opaque as on white paper", 1}});
}
