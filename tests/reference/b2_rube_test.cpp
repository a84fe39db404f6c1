// Imports of R.U.B.E. exports compared with Box2D: a small file of the project and, if TUMBLE_RUBE_DATA names a folder,
// the exports in it.
#include "reference/box2d/b2_rube.hpp"
#include "tumble/scene_import.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

using namespace tumble;
using namespace tumble::reference;

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
    scene.joints[0].anchors->first.x += 0.25;
    const ImportDifferences found = compare_with_box2d(kSmall, scene);
    CHECK(found.mass == doctest::Approx(0.002).epsilon(1e-4));
    CHECK(found.anchor == doctest::Approx(0.25).epsilon(1e-4));
    scene.joints.pop_back();
    CHECK_FALSE(compare_with_box2d(kSmall, scene).same_count);
}

TEST_CASE("the exports in TUMBLE_RUBE_DATA have the masses and the joint anchors of Box2D") {
    const char* folder = std::getenv("TUMBLE_RUBE_DATA");
    if (folder == nullptr) {
        MESSAGE("skipped: TUMBLE_RUBE_DATA names no folder with R.U.B.E. exports");
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") compare(entry.path());
}
