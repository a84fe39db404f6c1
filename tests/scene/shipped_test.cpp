// The shipped scenes: valid, described, framed, and free of overlaps at the start.
#include <doctest/doctest.h>

#include <set>
#include <utility>

#include "scene/model/names.hpp"
#include "scene/model/place.hpp"
#include "scene/shipped.hpp"
#include "tumble/body.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

using namespace tumble;

namespace {

struct Part {
    std::size_t body = 0;
    bool movable = false;
    CollisionFilter filter;
    Pose pose;
    Shape shape;
    Aabb box;
};

CollisionFilter filter_of(const SceneShape& shape) {
    if (!shape.filter) return {};
    return {shape.filter->category, shape.filter->mask, shape.filter->group};
}

std::vector<Part> parts_at_load(const Scene& scene) {
    std::vector<Part> parts;
    std::size_t built = 0;
    for (std::size_t source = 0; source < scene.bodies.size(); ++source) {
        const SceneBody& body = scene.bodies[source];
        for (const scene::PlacedBody& placed : scene::place_copies(scene.bodies[source], scene.world.seed, source)) {
            for (const SceneShape& shape : body.shapes)
                for (const Shape& part : make_shapes(shape.geometry))
                    parts.push_back({built, body.type == BodyType::dynamic_body, filter_of(shape), placed.pose, part,
                                     bounds(part, placed.pose)});
            ++built;
        }
    }
    return parts;
}

std::set<std::pair<std::size_t, std::size_t>> jointed_bodies(const Scene& scene) {
    const scene::BodyNames names(scene);
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (const SceneJoint& joint : scene.joints)
        if (!joint.collide_connected) pairs.insert(std::minmax(*names.find(joint.body_a), *names.find(joint.body_b)));
    return pairs;
}

}  // namespace

TEST_CASE("every shipped scene loads without a warning, has its file's name, a description and a camera") {
    const std::vector<std::filesystem::path> files = test::shipped_scenes();
    CHECK(files.size() >= 50);
    for (const std::filesystem::path& file : files) {
        CAPTURE(file);
        std::vector<Diagnostic> warnings;
        const Scene scene = load_scene(file, &warnings);
        for (const Diagnostic& warning : warnings) FAIL_CHECK(to_string(warning));
        CHECK(scene.schema == "scene.schema.json");
        CHECK(scene.name == file.stem());
        CHECK(scene.description.size() > 20);
        CHECK(scene.camera.center.has_value());
        CHECK(scene.camera.height.has_value());
    }
}

TEST_CASE("no two bodies of a shipped scene that may touch overlap at the start") {
    int compared = 0;
    for (const std::filesystem::path& file : test::shipped_scenes()) {
        const Scene scene = load_scene(file);
        const auto jointed = jointed_bodies(scene);
        std::vector<Part> parts = parts_at_load(scene);
        std::sort(parts.begin(), parts.end(),
                  [](const Part& a, const Part& b) { return a.box.lower.x < b.box.lower.x; });
        for (std::size_t i = 0; i < parts.size(); ++i) {
            for (std::size_t j = i + 1; j < parts.size() && parts[j].box.lower.x <= parts[i].box.upper.x; ++j) {
                const Part &a = parts[i], &b = parts[j];
                if (a.body == b.body || !(a.movable || b.movable) || !overlaps(a.box, b.box)) continue;
                if (!may_meet(a.filter, b.filter)) continue;
                if (jointed.contains(std::minmax(a.body, b.body))) continue;
                ++compared;
                // A rotation of two floats turns a point by up to 1e-7 of its distance from the origin.
                const DistanceResult result = distance(a.shape, a.pose, b.shape, b.pose);
                const std::string where = file.filename().string() + ": bodies " + std::to_string(a.body) + " and " +
                                          std::to_string(b.body) + " overlap by " + std::to_string(-result.distance);
                CHECK_MESSAGE(result.distance > -1e-5, where);
            }
        }
    }
    CHECK(compared > 1000);
}
