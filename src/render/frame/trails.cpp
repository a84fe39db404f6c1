#include "render/frame/trails.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include "render/shapes/shape_primitives.hpp"
#include "render/style/style.hpp"

namespace tumble {
namespace render {
namespace {

constexpr double kTrailWidth = 2.0;  // pixels at 720 rows
constexpr double kTrailStep = 2.0;   // pixels: points nearer to the last one drawn are left out
constexpr double kTrailOpacity = 0.7;
constexpr double kSkinOpacity = 0.35;  // of the area inside
constexpr std::size_t kFewestOfSkin = 3;

DVec2 center_of(const World& world, BodyId body) {
    return transform_point(world.state(body).pose, world.mass(body).center);
}

// The colour of the first shape of the body, as of the first of its copies.
Color fill_of(const Palette& palette, const SceneInstance& body, std::size_t shapes) {
    std::vector<Paint> paints(std::max<std::size_t>(shapes, 1));
    palette.paint_body(body.source, 0, paints);
    return paints.front().fill;
}

void add_trail(Layer& layer, const View& view, const Trail& trail, Color color) {
    if (trail.points.empty()) return;
    DVec2 from = view.to_pixels(trail.points.front());
    for (std::size_t i = 1; i < trail.points.size(); ++i) {
        const DVec2 to = view.to_pixels(trail.points[i]);
        if (i + 1 < trail.points.size() && length(to - from) < kTrailStep) continue;
        if (length(to - from) > 0.0) add_line(layer, view, from, to, kTrailWidth * view.detail(), color);
        from = to;
    }
}

MeshVertex skin_vertex(DVec2 at, Color color) {
    // Deep inside the shape, so that no edge is drawn.
    constexpr float kDeep = -1e4f;
    return {static_cast<float>(at.x), static_cast<float>(at.y), kDeep, flat(color)};
}

// The loop as a fan about its middle: exact for loops that the middle sees as a whole, as those of blown-up bodies.
void add_skin(Layer& layer, const View& view, const std::vector<DVec2>& loop, double width, Color fill) {
    DVec2 middle{};
    for (const DVec2 point : loop) middle = middle + (1.0 / static_cast<double>(loop.size())) * point;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const DVec2 from = loop[i], to = loop[(i + 1) % loop.size()];
        for (const DVec2 corner : {middle, from, to})
            layer.mesh.push_back(skin_vertex(corner, faded(fill, kSkinOpacity)));
        if (length(to - from) > 0.0) add_line(layer, view, from, to, width, fill);
    }
}

}  // namespace

void add_trails(Layer& layer, const View& view, const Scene& scene, const SceneWorld& world,
                std::span<const Trail> trails, const Palette& palette) {
    for (const Trail& trail : trails) {
        const auto body = std::ranges::find(world.bodies, trail.body, &SceneInstance::id);
        if (body == world.bodies.end()) continue;
        const std::size_t shapes = world.world.is_valid(trail.body) ? world.world.shapes(trail.body).size()
                                                                    : source_of(scene, *body).shapes.size();
        add_trail(layer, view, trail, faded(fill_of(palette, *body, shapes), kTrailOpacity));
    }
}

void add_skins(Layer& layer, const View& view, const Scene& scene, const SceneWorld& world, const Palette& palette) {
    for (std::size_t first = 0, end = 0; first < world.bodies.size(); first = end) {
        const SceneInstance& body = world.bodies[first];
        while (end < world.bodies.size() && world.bodies[end].source == body.source) ++end;
        if (end - first < kFewestOfSkin || !source_of(scene, body).skin) continue;
        std::vector<DVec2> loop;
        double radius = 0.0;
        for (std::size_t i = first; i < end; ++i) {
            const BodyId id = world.bodies[i].id;
            if (!world.world.is_valid(id)) break;
            loop.push_back(view.to_pixels(center_of(world.world, id)));
            for (const ShapeId shape : world.world.shapes(id))
                radius =
                    std::max(radius, double{farthest_distance(world.world.shape(shape), world.world.mass(id).center)});
        }
        if (loop.size() < end - first) continue;
        const Color fill = fill_of(palette, body, world.world.shapes(body.id).size());
        add_skin(layer, view, loop, std::max(2.0 * radius * view.scale, style::kSegment * view.detail()), fill);
    }
}

std::vector<BodyId> bodies_with_skin(const Scene& scene, const SceneWorld& world) {
    std::vector<BodyId> skinned;
    for (const SceneInstance& body : world.bodies)
        if (source_of(scene, body).skin) skinned.push_back(body.id);
    return skinned;
}

bool is_below_skin(const World& world, JointId joint, std::span<const BodyId> skinned) {
    if (skinned.empty() || !world.is_valid(joint)) return false;
    const auto* const rod = std::get_if<DistanceJointDef>(&world.joint(joint));
    return rod != nullptr &&
           std::ranges::any_of(skinned, [&](BodyId body) { return body == rod->body_a || body == rod->body_b; });
}

}  // namespace render

void record_trails(std::vector<Trail>& trails, const Scene& scene, const SceneWorld& world) {
    for (const SceneInstance& body : world.bodies) {
        if (!source_of(scene, body).trail || !world.world.is_valid(body.id)) continue;
        auto trail = std::ranges::find(trails, body.id, &Trail::body);
        if (trail == trails.end()) trail = trails.insert(trails.end(), Trail{.body = body.id});
        if (world.world.step_count() % trail->stride != 0) continue;
        trail->points.push_back(render::center_of(world.world, body.id));
        if (trail->points.size() < kMostTrailPoints) continue;
        std::vector<DVec2> kept;
        for (std::size_t i = 0; i < trail->points.size(); i += 2) kept.push_back(trail->points[i]);
        trail->points = std::move(kept);
        trail->stride *= 2;
    }
}

}  // namespace tumble
