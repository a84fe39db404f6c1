#include "reference/box2d/b2_rube.hpp"
#include "tumble/scene_import.hpp"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>
#include <string>

#include "tumble/scene_file.hpp"

#include "support/near.hpp"
#include "support/rube_export.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;

namespace {

constexpr double kAllowed = 1e-5;  // of float input, relative or m

void compare(const std::filesystem::path& file) {
    CAPTURE(file.string());
    const ImportDifferences found = compare_with_box2d(file, import_rube(file).scene);
    CHECK(found.same_count);
    CHECK(found.mass.value <= kAllowed);
    CHECK(found.center.value <= kAllowed);
    CHECK(found.inertia.value <= kAllowed);
    CHECK(found.anchor.value <= kAllowed);
}

const std::filesystem::path kSmall = std::filesystem::path(TUMBLE_SOURCE_DIR) / "tests/import/data/rube_small.json";

}  // namespace

TEST_CASE("an import has the masses and the joint anchors of Box2D") {
    compare(kSmall);
    CHECK(compare_with_box2d(kSmall, import_rube(kSmall).scene).bodies == 3);
    CHECK(compare_with_box2d(kSmall, import_rube(kSmall).scene).joints >= 9);
}

TEST_CASE("the comparison reads comments and the wrapper of a JavaScript file, as the importer does") {
    std::ostringstream small;
    small << std::ifstream(kSmall).rdbuf();
    const std::filesystem::path file = std::filesystem::path(TUMBLE_BINARY_DIR) / "wrapped_export.js";
    for (const std::string& text : {"// }\n" + small.str() + " /* { */", "var scene = " + small.str() + ";\n"}) {
        std::ofstream(file) << text;
        bool is_read = true;
        try {
            import_rube(file);
        } catch (const SceneError&) {
            is_read = false;
        }
        CAPTURE(text.substr(0, 20));
        if (is_read) compare(file);
        CHECK(is_read);
    }
}

TEST_CASE("the comparison detects another mass, another anchor and a missing joint") {
    Scene scene = import_rube(kSmall).scene;
    for (SceneBody& body : scene.bodies)
        if (body.name == "crate_2") body.mass = SceneMass{5.01, {}, 0.0};
    scene.joints.at(0).anchors->first.x += 0.25;
    const ImportDifferences found = compare_with_box2d(kSmall, scene);
    CHECK(near(found.mass.value, 0.002, absolute(1e-7)));
    CHECK(found.mass.owner == "crate_2");
    CHECK(near(found.anchor.value, 0.25, kFloat));
    scene.joints.pop_back();
    CHECK_FALSE(compare_with_box2d(kSmall, scene).same_count);
}

TEST_CASE("the bodies and joints of a large export are those of Box2D") {
    const RubeExport made = make_rube_export(300);
    const std::filesystem::path file = std::filesystem::path(TUMBLE_BINARY_DIR) / "large_rube_export.json";
    std::ofstream(file) << made.text;
    compare(file);
    const ImportDifferences found = compare_with_box2d(file, import_rube(file).scene);
    CHECK(found.bodies == made.bodies - 1);  // the ground has no mass
    CHECK(found.joints == made.joints);
}

namespace {

// The text with one of its numbers replaced by another, or with an unknown key.
std::string mutate(const std::string& text, std::mt19937& random) {
    static constexpr std::array<const char*, 16> kValues = {"0",
                                                            "-1",
                                                            "1",
                                                            "2",
                                                            "3",
                                                            "1e-30",
                                                            "1e30",
                                                            "-1e9",
                                                            "1e9",
                                                            "0.5",
                                                            "true",
                                                            "false",
                                                            "\"3F800000\"",
                                                            "\"00000001\"",
                                                            "{\"x\": 3, \"y\": -4}",
                                                            "[]"};
    static const std::regex place(R"re(-?[0-9][0-9.eE+-]*|"[0-9A-F]{8}"|true|false|"[a-zA-Z-]+": ?)re");
    std::string result = text;
    for (int left = 1 + static_cast<int>(random() % 3); left > 0; --left) {
        const auto count = std::distance(std::sregex_iterator(result.begin(), result.end(), place), {});
        auto found = std::sregex_iterator(result.begin(), result.end(), place);
        std::advance(found, static_cast<std::ptrdiff_t>(random() % static_cast<std::uint64_t>(count)));
        const bool is_key = (*found)[0].str().find(':') != std::string::npos;
        result.replace(static_cast<std::size_t>(found->position()), static_cast<std::size_t>(found->length()),
                       is_key ? "\"unknown\": " : kValues[random() % kValues.size()]);
    }
    return result;
}

// An export with one dynamic body of these members.
std::filesystem::path export_of(const std::string& body) {
    std::filesystem::path file = std::filesystem::path(TUMBLE_BINARY_DIR) / "one_body_export.json";
    std::ofstream(file) << R"({"gravity": 0, "body": [{"type": 2, "name": "wheel", "awake": true, )" << body << "}]}";
    return file;
}

}  // namespace

TEST_CASE("an inertia that Box2D refuses is counted, and the rest of the body is compared") {
    // m c^2 = 2 * 3^2 = 18 kg m^2 is more than I = 17.
    const std::filesystem::path file = export_of(
        R"("massData-mass": 2, "massData-I": 17, "massData-center": {"x": 3, "y": 0},
           "fixture": [{"density": 1, "circle": {"radius": 1, "center": 0}}])");
    const ImportDifferences found = compare_with_box2d(file, import_rube(file).scene);
    CHECK(found.refused_inertias == 1);
    CHECK(found.bodies == 1);
    CHECK(found.mass.value == 0.0);
    CHECK(found.center.value <= kAllowed);
    CHECK(found.inertia.value == 0.0);
}

TEST_CASE("bodies with fixed rotation agree, whatever their shapes and mass data are") {
    for (const char* data : {R"("massData-mass": 3.14159265, "massData-I": 1.57)", R"("massData-mass": 5)",
                             R"("massData-mass": 2, "massData-I": 17, "massData-center": {"x": 3, "y": 0})"}) {
        CAPTURE(std::string(data));
        const std::filesystem::path file = export_of(std::string(R"("fixedRotation": true, "fixture": [{"density": 1,
                                     "circle": {"radius": 1, "center": 0}}], )") +
                                                     data);
        compare(file);
        const ImportDifferences found = compare_with_box2d(file, import_rube(file).scene);
        CHECK(found.refused_inertias == 0);
    }
}

TEST_CASE("the rounding of Box2D's coordinates far from the origin is no difference of anchors") {
    // At 1e7 m, float coordinates are 1 m apart.
    const std::filesystem::path file = std::filesystem::path(TUMBLE_BINARY_DIR) / "far_export.json";
    std::ofstream(file) << R"({"gravity": 0, "body": [{"type": 2, "awake": true, "position": {"x": 1e7, "y": 3.3}},
        {"type": 0, "position": {"x": 1e7, "y": 0}}], "joint": [{"type": "revolute", "bodyA": 0, "bodyB": 1,
        "anchorA": {"x": 0.3, "y": 0.7}, "anchorB": {"x": 0.3, "y": 4}}]})";
    compare(file);
    Scene moved = import_rube(file).scene;
    moved.joints.at(0).anchors->first.x += 50.0;
    const ImportDifferences found = compare_with_box2d(file, moved);
    CHECK(found.anchor.value > 40.0);
    CHECK(found.anchor.owner == "joint[0]");
}

TEST_CASE("mutated exports are refused, or compared with Box2D without an assertion") {
    std::ostringstream small;
    small << std::ifstream(kSmall).rdbuf();
    const std::array<std::string, 2> texts = {small.str(), make_rube_export(3).text};
    const std::filesystem::path file = std::filesystem::path(TUMBLE_BINARY_DIR) / "mutated_export.json";
    std::mt19937 random(7);
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::string text = mutate(texts[random() % texts.size()], random);
        std::ofstream(file) << text;
        try {
            const ImportDifferences found = compare_with_box2d(file, import_rube(file).scene);
            ++compared;
            CHECK_MESSAGE(found.same_count, text);
        } catch (const SceneError&) {
        }
    }
    CHECK(compared > 300);
    CHECK(compared < 900);
}
