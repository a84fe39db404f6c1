#include "render/frame/overlay.hpp"

#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "debug/check.hpp"
#include "render/frame/forces.hpp"
#include "render/frame/marks.hpp"
#include "render/shapes/shape_primitives.hpp"
#include "render/style/palette.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

// Lengths in pixels at 720 rows.
constexpr double kNormalLength = 20.0;
constexpr double kThin = 1.0;

constexpr double kVelocityTime = 0.1;  // s: an arrow shows the displacement in this time
constexpr const char* kVelocityLegend = "velocity: displacement in 0.1 s";
constexpr double kAsleep = 0.65;  // share of the background in the colour of a sleeping island

void add_boxes(Marks& marks, const View& view, const World& world, Color color) {
    for (const BodyId body : world.bodies())
        for (const ShapeId shape : world.shapes(body)) {
            const Aabb box = bounds(world.shape(shape), world.state(body).pose);
            const DVec2 low = view.to_pixels(DVec2(box.lower)), high = view.to_pixels(DVec2(box.upper));
            const DVec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
            for (int i = 0; i < 4; ++i) marks.line(corners[i], corners[(i + 1) % 4], kThin, color);
        }
}

void add_islands(Layer& layer, const View& view, const World& world, const Colors& colors) {
    const std::vector<int> islands = world.islands();
    TUMBLE_CHECK(islands.size() == world.bodies().size());
    for (std::size_t i = 0; i < islands.size(); ++i) {
        if (islands[i] < 0) continue;
        const BodyId body = world.bodies()[i];
        const Color awake = colors.bodies[static_cast<std::size_t>(islands[i]) % colors.bodies.size()];
        const Color color = world.is_awake(body) ? awake : mix(awake, colors.background, kAsleep);
        const Paint paint{color, outline_of(awake, colors)};
        for (const ShapeId shape : world.shapes(body))
            if (!world.is_sensor(shape))
                add_shape(layer, view, world.shape(shape), world.state(body).pose, paint,
                          style::kSegment * view.detail());
    }
}

void add_contacts(Marks& marks, const View& view, const World& world, const Overlay& overlay, const Colors& colors) {
    for (const ContactPoint& point : world.contacts()) {
        const DVec2 at = view.to_pixels(point.point);
        if (overlay.normals) marks.arrow(at, at + marks.pixels(kNormalLength) * DVec2(point.normal), colors.normal);
        if (overlay.contacts) marks.dot(at, point.separation < 0.0f ? colors.overlapping : colors.separated);
    }
}

void add_velocities(Marks& marks, const View& view, const World& world, Color color) {
    for (const BodyId body : world.bodies()) {
        const BodyState state = world.state(body);
        const DVec2 center = transform_point(state.pose, world.mass(body).center);
        marks.arrow(view.to_pixels(center), view.to_pixels(center + kVelocityTime * DVec2(state.velocity)), color);
    }
}

// From a body's centre of mass to its anchor. A static body gets only the mark of the anchor.
void add_joint_line(Marks& marks, const View& view, const World& world, BodyId body, DVec2 anchor, Color color) {
    const DVec2 at = view.to_pixels(anchor);
    if (world.type(body) != BodyType::static_body)
        marks.line(view.to_pixels(transform_point(world.state(body).pose, world.mass(body).center)), at, kMarkWidth,
                   color);
    marks.dot(at, color);
}

void add_joint_lines(Marks& marks, const View& view, const World& world, Color color) {
    for (const JointId id : world.joints()) {
        const std::optional<JointAnchors> anchors = world.joint_anchors(id);
        if (!anchors) continue;
        const auto [a, b] =
            std::visit([](const auto& joint) { return std::pair(joint.body_a, joint.body_b); }, world.joint(id));
        add_joint_line(marks, view, world, a, anchors->a, color);
        add_joint_line(marks, view, world, b, anchors->b, color);
    }
}

}  // namespace

void add_overlay(DrawList& list, const View& view, const World& world, const Overlay& overlay, const Colors& colors) {
    Marks marks(list.overlay, view, colors.background);
    if (overlay.islands) add_islands(list.islands, view, world, colors);
    if (overlay.aabbs) add_boxes(marks, view, world, colors.box_edge);
    if (overlay.joints) add_joint_lines(marks, view, world, colors.joint_line);
    if (overlay.velocity) add_velocities(marks, view, world, colors.velocity);
    if (overlay.forces) add_forces(marks, view, world, colors.force);
    if (overlay.contacts || overlay.normals) add_contacts(marks, view, world, overlay, colors);
}

namespace {

std::string force_legend(const View& view, const World& world) {
    char text[80];
    std::snprintf(text, sizeof text, "force of a contact: %.0f pixels are %g N", kForceLength * view.detail(),
                  force_unit(world));
    return text;
}

bool has_sensors(const World& world) {
    for (const BodyId body : world.bodies())
        for (const ShapeId shape : world.shapes(body))
            if (world.is_sensor(shape)) return true;
    return false;
}

}  // namespace

std::vector<LegendLine> legend_of(const Overlay& overlay, const View& view, const World& world, const Colors& colors) {
    using Mark = LegendLine::Mark;
    std::vector<LegendLine> lines;
    if (overlay.contacts) {
        lines.push_back({Mark::dot, colors.overlapping, "contact, overlapping"});
        lines.push_back({Mark::dot, colors.separated, "contact, separated"});
    }
    if (overlay.normals) lines.push_back({Mark::line, colors.normal, "normal, from A to B"});
    if (overlay.aabbs) lines.push_back({Mark::line, colors.box_edge, "bounding box"});
    if (overlay.islands) lines.push_back({Mark::area, colors.bodies[0], "island: one colour each, pale if asleep"});
    if (overlay.velocity) lines.push_back({Mark::line, colors.velocity, kVelocityLegend});
    if (overlay.joints) lines.push_back({Mark::line, colors.joint_line, "joint: lines to its bodies"});
    if (overlay.forces) lines.push_back({Mark::line, colors.force, force_legend(view, world)});
    if (!lines.empty() && has_sensors(world))
        lines.push_back({Mark::area, faded(colors.static_fill, style::kSensorOpacity), "sensor"});
    return lines;
}

}  // namespace tumble::render
