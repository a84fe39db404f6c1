#include "render/frame/draw_list.hpp"

#include <variant>

#include "debug/check.hpp"
#include "render/frame/grid.hpp"
#include "render/frame/joint_marks.hpp"
#include "render/shapes/chain_band.hpp"
#include "render/shapes/joined_parts.hpp"
#include "render/shapes/orientation_mark.hpp"
#include "render/shapes/sensor_area.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/palette.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

constexpr double kMarkOpacity = 0.6;

// A body of several shapes shows its angle without a mark, unless they are circles.
bool has_mark(const Shape& shape, std::size_t shape_count) { return shape_count == 1 || shape.vertex_count() == 1; }

void add_chain_bands(std::vector<MeshVertex>& mesh, const View& view, const SceneBody& body, const Pose& pose,
                     Color color) {
    for (const SceneShape& shape : body.shapes)
        if (const auto* chain = std::get_if<ChainGeometry>(&shape.geometry); chain && !chain->two_sided)
            add_chain_band(mesh, view, chain->points, chain->loop, pose, color);
}

}  // namespace

void build_draw_list(DrawList& list, const Scene& scene, const SceneWorld& world, const View& view) {
    for (Layer* const layer : list.layers()) {
        layer->clear();
        layer->outline_width = style::kOutline * view.detail();
    }
    list.background = style::kBackground;
    add_grid(list.grid, view);

    const Palette palette(scene);
    const double line_width = style::kSegment * view.detail();
    std::vector<Paint> paints;
    std::vector<Part> parts;
    std::size_t ordinal = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const SceneInstance& body = world.bodies[i];
        TUMBLE_CHECK(body.source < scene.bodies.size() + scene.timeline.size());
        ordinal = i > 0 && world.bodies[i - 1].source == body.source ? ordinal + 1 : 0;
        if (!world.world.is_valid(body.id)) continue;
        const std::span<const ShapeId> shapes = world.world.shapes(body.id);
        const Pose pose = world.world.state(body.id).pose;
        const bool is_static = world.world.type(body.id) == BodyType::static_body;
        paints.resize(shapes.size());
        palette.paint_body(body.source, ordinal, paints);
        if (is_static && !paints.empty())
            add_chain_bands(list.ground.mesh, view, source_of(scene, body), pose, paints.front().outline);
        parts.clear();
        for (std::size_t k = 0; k < shapes.size(); ++k) {
            const Shape& shape = world.world.shape(shapes[k]);
            if (world.world.is_sensor(shapes[k]))
                add_sensor_area(list.sensors, view, shape, pose, paints[k]);
            else
                parts.push_back({&shape, paints[k]});
        }
        find_joined(parts);
        Layer& layer = is_static ? list.ground : list.bodies;
        add_joined_parts(layer, view, parts, pose);
        for (const Part& part : parts) {
            if (!part.is_joined) add_shape(layer, view, *part.shape, pose, part.paint, line_width);
            if (!is_static && has_mark(*part.shape, shapes.size()))
                add_orientation_mark(list.details, view, *part.shape, pose, faded(part.paint.outline, kMarkOpacity));
        }
    }
    add_joints(list.details, view, world.world, world.joints);
}

}  // namespace tumble::render
