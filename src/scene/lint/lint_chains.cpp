// A chain is solid on the left of its direction. Bodies fall through a ground whose points are in the wrong order. A
// ray from the centre of a body along gravity finds the ground below it: if the ray hits the solid side of a one-sided
// chain, the body will fall through.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "debug/check.hpp"
#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kDeep = 1e4;  // m, times the scale: the length of the ray

bool is_one_sided(const SceneShape& shape) {
    const auto* chain = std::get_if<ChainGeometry>(&shape.geometry);
    return chain && !chain->two_sided && !shape.sensor;
}

// Which of the body's shapes in the scene a shape of the world belongs to.
std::size_t index_of_source(const World& world, const SceneInstance& body, const SceneBody& source, ShapeId id) {
    std::size_t before = 0, index = 0;
    for (const ShapeId shape : world.shapes(body.id)) {
        if (shape == id) break;
        ++before;
    }
    for (; index + 1 < source.shapes.size(); ++index) {
        const std::size_t parts = make_shapes(source.shapes[index].geometry).size();
        if (before < parts) break;
        before -= parts;
    }
    TUMBLE_CHECK(index < source.shapes.size());
    return index;
}

class ChainLinter {
public:
    ChainLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene), built_(built), diagnostics_(diagnostics) {}

    void lint(const SceneInstance& body) {
        const World& world = built_.world;
        const SceneBody& source = scene_.bodies[body.source];
        if (source.type != BodyType::dynamic_body || !source.enabled || !(source.gravity_scale > 0.0) ||
            source.shapes.empty())
            return;
        const DVec2 center = transform_point(world.state(body.id).pose, world.mass(body.id).center);
        const DVec2 down = (scene_.world.scale * kDeep / length(scene_.world.gravity)) * scene_.world.gravity;
        QueryFilter filter{.except = body.id};
        if (const std::optional<SceneFilter>& own = source.shapes.front().filter)
            filter.shape = {own->category, own->mask, own->group};
        for (const CastHit& hit : world.cast_ray_all(center, down, filter)) {
            if (world.type(hit.body) == BodyType::dynamic_body) continue;
            lint_ground(body, hit);
            return;
        }
    }

private:
    void lint_ground(const SceneInstance& body, const CastHit& hit) {
        const World& world = built_.world;
        const auto ground = std::ranges::find(built_.bodies, hit.body, &SceneInstance::id);
        const SceneBody& source = scene_.bodies[ground->source];
        const std::size_t index = index_of_source(world, *ground, source, hit.shape);
        if (!is_one_sided(source.shapes[index])) return;
        const Shape segment = world.shape(hit.shape);
        const DVec2 along = rotate(world.state(hit.body).pose.rotation, DVec2(segment.vertex(1) - segment.vertex(0)));
        const bool is_behind = cross(along, hit.normal) > 0.0;  // the normal points towards the start of the ray
        if (!is_behind || !reported_.insert({ground->source, index}).second) return;
        diagnostics_.warning(
            codes::behind_chain,
            "/bodies/" + std::to_string(ground->source) + "/shapes/" + std::to_string(index) + "/chain/points",
            display_name(built_, body.id) +
                " starts on the solid side of the chain and falls through it: bodies collide with a chain only "
                "from the right of its direction",
            R"(list the points in reverse order, those of a ground from right to left, or set "two_sided": true)");
    }

    const Scene& scene_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    std::set<std::pair<std::size_t, std::size_t>> reported_;  // body and shape of the scene
};

}  // namespace

void add_chain_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    const auto has_one = [](const SceneBody& body) { return std::ranges::any_of(body.shapes, is_one_sided); };
    if (!(length(scene.world.gravity) > 0.0) || std::ranges::none_of(scene.bodies, has_one)) return;
    ChainLinter linter(scene, built, diagnostics);
    for (const SceneInstance& body : built.bodies) linter.lint(body);
}

}  // namespace tumble::scene
