#include "reference/box2d/b2_rube.hpp"
#include "tumble/scene_import.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

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
    CHECK(found.mass <= kAllowed);
    CHECK(found.center <= kAllowed);
    CHECK(found.inertia <= kAllowed);
    CHECK(found.anchor <= kAllowed);
}

const std::filesystem::path kSmall = std::filesystem::path(TUMBLE_SOURCE_DIR) / "tests/import/data/rube_small.json";

}  // namespace

TEST_CASE("an import has the masses and the joint anchors of Box2D") {
    compare(kSmall);
    CHECK(compare_with_box2d(kSmall, import_rube(kSmall).scene).bodies == 3);
    CHECK(compare_with_box2d(kSmall, import_rube(kSmall).scene).joints >= 9);
}

TEST_CASE("the comparison detects another mass, another anchor and a missing joint") {
    Scene scene = import_rube(kSmall).scene;
    for (SceneBody& body : scene.bodies)
        if (body.name == "crate_2") body.mass = SceneMass{5.01, {}, 0.0};
    scene.joints.at(0).anchors->first.x += 0.25;
    const ImportDifferences found = compare_with_box2d(kSmall, scene);
    CHECK(near(found.mass, 0.002, absolute(1e-7)));
    CHECK(near(found.anchor, 0.25, kFloat));
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
