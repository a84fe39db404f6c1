#include "render/frame/draw_list.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <variant>
#include <vector>

#include "debug/check.hpp"
#include "render/frame/grid.hpp"
#include "render/frame/joint_marks.hpp"
#include "render/frame/trails.hpp"
#include "render/shapes/chain_band.hpp"
#include "render/shapes/hatching.hpp"
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

void clear(DrawList& list, const View& view, const Colors& colors) {
    for (Layer* const layer : list.layers()) {
        layer->clear();
        layer->outline_width = style::kOutline * view.detail();
    }
    list.background = colors.background;
    add_grid(list.grid, view, colors);
}

// Adds bodies to a draw list; keeps its buffers between them.
class BodyPainter {
public:
    BodyPainter(DrawList& list, const World& world, const View& view, const Look& look)
        : list_(list), world_(world), view_(view), look_(look) {}

    // Draws a body whose shapes have the given paints.
    void add(BodyId body, std::span<const Paint> paints) {
        const std::span<const ShapeId> shapes = world_.shapes(body);
        const Pose pose = world_.state(body).pose;
        const bool is_static = world_.type(body) == BodyType::static_body;
        parts_.clear();
        for (std::size_t k = 0; k < shapes.size(); ++k) {
            const Shape& shape = world_.shape(shapes[k]);
            if (world_.is_sensor(shapes[k]))
                add_sensor_area(list_.sensors, view_, shape, pose, paints[k]);
            else
                parts_.push_back({&shape, paints[k]});
        }
        find_joined(parts_);
        if (is_static && look_.style.hatching) hatch(pose);
        if (!is_static && look_.style.shadows) cast_shadow(pose);
        if (!is_static) mark(pose, shapes.size());
        if (!look_.style.outlines) remove_outlines();
        draw(is_static ? list_.ground : list_.bodies, pose);
    }

    // Draws a body that no scene describes.
    void add_plain(BodyId body) {
        const BodyType type = world_.type(body);
        const Colors& colors = look_.colors;
        const Color fill = type == BodyType::static_body      ? colors.static_fill
                           : type == BodyType::kinematic_body ? colors.kinematic_fill
                                                              : colors.bodies[body.index % colors.bodies.size()];
        paints_.assign(world_.shapes(body).size(), {fill, outline_of(fill, colors)});
        add(body, paints_);
    }

private:
    double line_width() const { return style::kSegment * view_.detail(); }

    void draw(Layer& layer, const Pose& pose) {
        add_joined_parts(layer, view_, parts_, pose);
        for (const Part& part : parts_)
            if (!part.is_joined) add_shape(layer, view_, *part.shape, pose, part.paint, line_width());
    }

    void hatch(const Pose& pose) {
        for (const Part& part : parts_)
            add_hatching(list_.hatching, view_, *part.shape, pose, faded(part.paint.outline, style::kHatchOpacity));
    }

    // The shapes again, moved to the lower right. Parts are not joined: the lines around joined ones would be darker.
    void cast_shadow(const Pose& pose) {
        const double metre = view_.detail() / view_.scale;  // of a pixel at 720 rows
        View moved = view_;
        moved.center = view_.center + metre * DVec2{-style::kShadowRight, style::kShadowDown};
        for (const Part& part : parts_)
            add_shape(list_.shadows, moved, *part.shape, pose, flat(look_.colors.shadow), line_width());
    }

    void mark(const Pose& pose, std::size_t shape_count) {
        for (const Part& part : parts_)
            if (has_mark(*part.shape, shape_count))
                add_orientation_mark(list_.details, view_, *part.shape, pose, faded(part.paint.outline, kMarkOpacity));
    }

    // A shape without area is drawn in the colour of its outline, which stays.
    void remove_outlines() {
        for (Part& part : parts_)
            if (part.shape->vertex_count() != 2 || part.shape->radius() > 0.0f) part.paint = flat(part.paint.fill);
    }

    DrawList& list_;
    const World& world_;
    const View& view_;
    const Look& look_;
    std::vector<Part> parts_;
    std::vector<Paint> paints_;
};

// The ids of `all` that are in none of the instances, in order.
template <class IdType, class Instance>
std::vector<IdType> ids_without(std::span<const IdType> all, const std::vector<Instance>& instances) {
    std::vector<IdType> known, others;
    for (const Instance& instance : instances) known.push_back(instance.id);
    std::sort(known.begin(), known.end());
    std::set_difference(all.begin(), all.end(), known.begin(), known.end(), std::back_inserter(others));
    return others;
}

}  // namespace

void build_draw_list(DrawList& list, const World& world, const View& view, const Look& look) {
    clear(list, view, look.colors);
    BodyPainter painter(list, world, view, look);
    for (const BodyId body : world.bodies()) painter.add_plain(body);
    add_joints(list.details, view, world, world.joints(), look.colors);
}

void build_draw_list(DrawList& list, const Scene& scene, const SceneWorld& world, const View& view,
                     std::span<const Trail> trails, const Look& look) {
    clear(list, view, look.colors);
    const Palette palette(scene, look.colors);
    BodyPainter painter(list, world.world, view, look);
    std::vector<Paint> paints;
    std::size_t ordinal = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const SceneInstance& body = world.bodies[i];
        TUMBLE_CHECK(body.source < scene.bodies.size() + scene.timeline.size());
        ordinal = i > 0 && world.bodies[i - 1].source == body.source ? ordinal + 1 : 0;
        if (!world.world.is_valid(body.id)) continue;
        paints.resize(world.world.shapes(body.id).size());
        palette.paint_body(body.source, ordinal, paints);
        if (world.world.type(body.id) == BodyType::static_body && !paints.empty())
            add_chain_bands(list.ground.mesh, view, source_of(scene, body), world.world.state(body.id).pose,
                            paints.front().outline);
        painter.add(body.id, paints);
    }
    add_trails(list.sensors, view, scene, world, trails, palette);
    add_skins(list.islands, view, scene, world, palette);
    for (const BodyId body : ids_without(world.world.bodies(), world.bodies)) painter.add_plain(body);
    std::vector<JointId> joints;
    const std::vector<BodyId> skinned = bodies_with_skin(scene, world);
    for (const SceneJointInstance& joint : world.joints)
        if (!is_below_skin(world.world, joint.id, skinned)) joints.push_back(joint.id);
    const std::vector<JointId> added = ids_without(world.world.joints(), world.joints);
    joints.insert(joints.end(), added.begin(), added.end());
    add_joints(list.details, view, world.world, joints, look.colors);
}

}  // namespace tumble::render
