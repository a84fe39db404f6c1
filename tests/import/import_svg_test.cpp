// The SVG importer: what each figure becomes, and the notes on features that are left out.
#include <doctest/doctest.h>

#include <map>
#include <random>
#include <string>

#include "drawings.hpp"
#include "support/near.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

const std::filesystem::path kData = std::filesystem::path(TUMBLE_SOURCE_DIR) / "tests/import/data";

const SceneBody& body_named(const ImportedScene& imported, const std::string& name) {
    for (const SceneBody& body : imported.scene.bodies)
        if (body.name == name) return body;
    FAIL("no body " << name);
    return imported.scene.bodies.front();
}

std::string error_of(const std::string& text) {
    try {
        parse_svg(text, "test.svg");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a figure of each kind becomes a body, 100 units to a metre, y upwards from the lower edge") {
    const ImportedScene imported = import_svg(kData / "figures.svg");
    CHECK(imported.notes.empty());
    CHECK(imported.scene.name == "figures");
    CHECK(imported.scene.bodies.size() == 9);
    CHECK_FALSE(imported.scene.camera.center.has_value());  // a camera that stands still follows nothing
    CHECK_FALSE(imported.scene.camera.height.has_value());

    const SceneBody& floor = body_named(imported, "static-floor");
    CHECK(floor.type == BodyType::static_body);
    CHECK(near(floor.position, {2.0, 0.1}));
    CHECK(near(only_shape<BoxGeometry>(floor).size, {4.0, 0.2}));
    CHECK(floor.shapes.at(0).material == "#445566");

    const SceneBody& crate = body_named(imported, "crate");
    CHECK(crate.type == BodyType::dynamic_body);
    CHECK(near(crate.position, {0.7, 1.9}));  // (70, 110) of 300
    CHECK(near(only_shape<BoxGeometry>(crate).size, {0.4, 0.2}));
    CHECK(only_shape<BoxGeometry>(crate).angle == 0.0);
    CHECK(crate.shapes.at(0).material == "#ffa500");

    CHECK(near(only_shape<BoxGeometry>(body_named(imported, "pill")).radius, 0.05, kDouble));
    CHECK(body_named(imported, "pill").shapes.at(0).material == "#0a141e");
    CHECK(near(only_shape<CircleGeometry>(body_named(imported, "ball")).radius, 0.25, kDouble));
    // The chords of the ellipse are inside it by at most the tolerance of 5 mm: its area is pi a b = 0.0628 m^2 less at
    // most the tolerance times the perimeter, 0.97 m.
    const double egg = area_of(body_named(imported, "egg"));
    CHECK(egg < kPi * 0.2 * 0.1);
    CHECK(egg > kPi * 0.2 * 0.1 - 0.005 * 0.97);

    const SceneBody& ramp = body_named(imported, "ramp");
    CHECK(ramp.type == BodyType::static_body);
    const ChainGeometry& line = only_shape<ChainGeometry>(ramp);
    CHECK(line.two_sided);
    CHECK(!line.loop);
    REQUIRE(line.points.size() == 2);
    CHECK(near(ramp.position + line.points[0], {0.2, 1.0}));
    CHECK(near(ramp.position + line.points[1], {1.2, 0.8}));
    CHECK(only_shape<ChainGeometry>(body_named(imported, "bumps")).points.size() == 4);
    CHECK(only_shape<OutlineGeometry>(body_named(imported, "arrow")).points.size() == 4);
    CHECK(near(area_of(body_named(imported, "arrow")), 0.5 * 0.4 * 0.4 - 0.5 * 0.4 * 0.1, kFloat));
    CHECK(area_of(body_named(imported, "drop")) > 0.0);
}

TEST_CASE("layers, style sheets and clones of drawing programs are imported, other features are noted") {
    // 100 user units of the viewBox are 100 mm: a unit is 96 / 25.4 pixels, of 0.01 m each by default.
    SvgOptions options;
    options.metres_per_pixel = 0.01 * 25.4 / 96.0;
    const ImportedScene imported = import_svg(kData / "editor.svg", options);
    const std::map<std::string, int> expected = {
        {"clip paths", 1},
        {"gradients and patterns", 1},
        {"hidden elements", 1},
        {"images", 1},
        {"outlines that cross themselves, whose hull is taken", 1},
        {"style rules with other selectors than a tag, class or id", 1},
        {"texts", 1},
    };
    CHECK(notes_of(imported) == expected);
    REQUIRE(imported.scene.bodies.size() == 8);

    const SceneBody& brick = body_named(imported, "brick");
    CHECK(near(only_shape<BoxGeometry>(brick).size, {0.1, 0.05}, 1e-9));
    CHECK(near(brick.position, {0.2, 0.725}));  // (10 + 5 + 5, 20 + 5 + 2.5) of 100
    CHECK(brick.shapes.at(0).material == "#a52a2a");
    // Turned by 90 degrees in a plane that is then mirrored: (40, 20) is its corner, it reaches 5 to the left, 10 down.
    const SceneBody& turned = body_named(imported, "brick-2");
    CHECK(near(turned.position, {0.375, 0.75}));
    CHECK(only_shape<BoxGeometry>(turned).angle == -90.0);

    const SceneBody& plank = imported.scene.bodies.at(2);
    CHECK(plank.type == BodyType::static_body);
    CHECK(only_shape<OutlineGeometry>(plank).points.size() == 8);
    CHECK(near(area_of(plank), 1.0 * 0.1 - 0.2 * 0.05, kFloat));

    CHECK(imported.scene.bodies.at(3).type == BodyType::static_body);
    CHECK(imported.scene.bodies.at(3).shapes.at(0).material == "#c0c0c0");
    const SceneBody& wire = imported.scene.bodies.at(4);
    CHECK(wire.type == BodyType::dynamic_body);
    REQUIRE(wire.shapes.size() == 2);
    CHECK(near(std::get<CapsuleGeometry>(wire.shapes.at(0).geometry).radius, 0.01, kDouble));
}

TEST_CASE("an imported scene is a valid scene file and a world that steps") {
    for (const char* name : {"figures.svg", "editor.svg"}) {
        const Scene scene = import_svg(kData / name).scene;
        const Scene again = parse_scene(to_json(scene), "imported.json");
        CHECK(to_json(again) == to_json(scene));
        SceneWorld built = build_world(again);
        CHECK(built.bodies.size() == scene.bodies.size());
        for (int step = 0; step < 30; ++step) built.world.step();
    }
}

TEST_CASE("filled figures are dynamic, lines are static, and a type that is stated overrides both") {
    const auto type_of = [](const std::string& content) {
        const ImportedScene imported = import_text(content);
        REQUIRE(imported.scene.bodies.size() == 1);
        return imported.scene.bodies.at(0).type;
    };
    const std::string box = "width='10' height='10'/>", none = "fill='none' stroke='red' ";
    CHECK(type_of("<rect " + box) == BodyType::dynamic_body);
    CHECK(type_of("<rect " + none + box) == BodyType::static_body);
    CHECK(type_of("<rect data-type='kinematic' " + box) == BodyType::kinematic_body);
    CHECK(type_of("<rect class='a static b' " + box) == BodyType::static_body);
    CHECK(type_of("<rect id='static_3' " + box) == BodyType::static_body);
    CHECK(type_of("<rect id='static_3' data-type='dynamic' " + box) == BodyType::dynamic_body);
    CHECK(type_of("<g class='static'><g><rect " + box + "</g></g>") == BodyType::static_body);
    CHECK(type_of("<g class='static'><rect class='dynamic' " + box + "</g>") == BodyType::dynamic_body);
    CHECK(type_of("<polyline points='0 0 9 0 9 9'/>") == BodyType::dynamic_body);  // SVG closes what it fills
    CHECK(type_of("<polyline stroke='red' points='0 0 9 0 9 9'/>") == BodyType::static_body);
    // A closed line of a dynamic body has an area.
    const ImportedScene hoop = import_text("<circle data-type='dynamic' r='9' " + none + "/>");
    CHECK(near(only_shape<CircleGeometry>(hoop.scene.bodies.at(0)).radius, 0.09, kDouble));
    const ImportedScene ring = import_text("<circle r='9' " + none + "/>");
    CHECK(only_shape<ChainGeometry>(ring.scene.bodies.at(0)).loop);
    CHECK(notes_of(import_text("<line x2='9'/>")) == std::map<std::string, int>{{"hidden elements", 1}});
}

TEST_CASE("circles and boxes are kept under similarity transforms only") {
    const auto only_body = [](const std::string& content) { return import_text(content).scene.bodies.at(0); };
    const SceneBody box =
        only_body("<rect x='-2' y='-1' width='4' height='2' transform='translate(50 50) rotate(30) scale(3)'/>");
    CHECK(near(only_shape<BoxGeometry>(box).size, {0.12, 0.06}));
    CHECK(near(only_shape<BoxGeometry>(box).angle, -30.0, kDouble));  // clockwise, as y is turned
    CHECK(near(box.position, {0.5, 0.5}));
    const SceneBody stretched = only_body("<circle r='10' transform='translate(50 50) scale(2 1)'/>");
    CHECK(std::holds_alternative<PolygonGeometry>(stretched.shapes.at(0).geometry));
    const SceneBody sheared = only_body("<rect width='10' height='10' transform='skewX(45)'/>");
    CHECK(near(area_of(sheared), 0.01, kFloat));  // a shear keeps the area
    CHECK(only_shape<PolygonGeometry>(sheared).vertices.size() == 4);
    const SceneBody uneven = only_body("<rect width='40' height='20' rx='10' ry='5'/>");
    // Four quarter ellipses are missing in full squares: 2 a b (4 - pi) / 2 in area, chords within 5 mm of 0.5 m of
    // arcs.
    CHECK(std::abs(area_of(uneven) - (0.08 - 0.1 * 0.05 * (4.0 - kPi))) < 0.005 * 0.5);
}

TEST_CASE("lengths in any unit, in percent and at any scale become metres") {
    const auto width_of = [](const std::string& width) {
        return only_shape<BoxGeometry>(import_text("<rect height='1' width='" + width + "'/>").scene.bodies.at(0))
            .size.x;
    };
    CHECK(near(width_of("96px"), 0.96, kDouble));
    CHECK(near(width_of("1in"), 0.96, kDouble));
    CHECK(near(width_of("25.4mm"), 0.96, kDouble));
    CHECK(near(width_of("2.54cm"), 0.96, kDouble));
    CHECK(near(width_of("72pt"), 0.96, kDouble));
    CHECK(near(width_of("50%"), 0.5, kDouble));
    SvgOptions options;
    options.metres_per_pixel = 1.0;
    CHECK(only_shape<CircleGeometry>(import_text("<circle r='3'/>", options).scene.bodies.at(0)).radius == 3.0);
    options.tolerance = 0.0;
    CHECK_THROWS_AS(import_text("", options), std::invalid_argument);
}

TEST_CASE("errors name the line, the column and what was expected") {
    CHECK(error_of("<svg>\n  <rect width='2' height='x'/>\n</svg>")
              .starts_with("test.svg:2:4: <rect>: height: expected a number at character 1, got \"x\""));
    CHECK(error_of("<svg>\n<path d='M0 0 L1'/>\n<circle r='-1'/></svg>")
              .find("test.svg:3:2: <circle>: r must not be negative") != std::string::npos);
    CHECK(error_of("<svg>\n <g>\n</svg>").starts_with("test.svg:3:"));
    CHECK(error_of("<html/>").find("expected an <svg> element, got \"html\"") != std::string::npos);
    CHECK(error_of("").find("test.svg") == 0);
    CHECK(error_of("<svg><rect data-type='heavy'/></svg>").find("data-type must be static, kinematic or dynamic") !=
          std::string::npos);
    CHECK(error_of("<svg><rect width='50%' height='1'/></svg>").find("width: a percentage needs") != std::string::npos);
    CHECK(error_of("<svg><g id='a'><use href='#a'/></g></svg>").find("references are nested deeper than 100") !=
          std::string::npos);
    CHECK_THROWS_AS(import_svg(kData / "missing.svg"), FileError);
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "<g>";
    CHECK(error_of("<svg>" + deep).find("test.svg:1:") == 0);
    std::string closed = deep;
    for (int i = 0; i < 100000; ++i) closed += "</g>";
    CHECK(error_of("<svg>" + closed + "</svg>").find("elements are nested deeper than 100") != std::string::npos);
}

TEST_CASE("references that multiply exponentially are refused") {
    std::string text = "<svg><rect id='r0' width='1' height='1'/>";
    for (int i = 1; i <= 40; ++i) {
        const std::string inner = "<use href='#r" + std::to_string(i - 1) + "'/>";
        text += "<g id='r" + std::to_string(i) + "' display='inline'>" + inner + inner + "</g>";
    }
    CHECK(error_of(text + "</svg>").find("more than 200000 elements") != std::string::npos);
}

TEST_CASE("mutated drawings are either refused or imported as valid scenes") {
    std::mt19937_64 random(31);
    std::map<bool, int> read;
    for (const char* name : {"figures.svg", "editor.svg"}) {
        const std::string original = read_file(kData / name, 1u << 20);
        for (int sample = 0; sample < 1000; ++sample) {
            std::string text = original;
            const std::string_view bytes = "0123456789.-+eE,%<>/\"'#=&; MmLlHhVvCcSsQqTtAaZz\n\x80\xff";
            for (std::uint64_t changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
                const std::size_t at = random() % text.size(), count = 1 + random() % 8;
                switch (random() % 4) {
                    case 0: text[at] = bytes[random() % bytes.size()]; break;
                    case 1: text.erase(at, count); break;
                    case 2: text.insert(at, std::string(count, bytes[random() % bytes.size()])); break;
                    default: text.insert(at, text.substr(random() % text.size(), 4 * count)); break;
                }
            }
            bool is_read = true;
            try {
                const Scene scene = parse_svg(text, "mutated.svg").scene;
                REQUIRE(parse_scene(to_json(scene), "mutated.json").bodies.size() == scene.bodies.size());
            } catch (const SceneError& error) {
                is_read = false;
                REQUIRE(std::string(error.what()).starts_with("mutated.svg:"));
            }
            ++read[is_read];
        }
    }
    CHECK(read[true] > 300);
    CHECK(read[false] > 300);
    MESSAGE(read[true] << " of " << read[true] + read[false] << " mutations were read");
}
