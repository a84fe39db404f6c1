#include "render/frame/marking.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "render/frame/marks.hpp"
#include "render/shapes/outline_mesh.hpp"
#include "render/view/box.hpp"

namespace tumble::render {
namespace {

// Pixels at 720 rows.
constexpr double kEdge = 3.0;      // width of an outline
constexpr double kPointer = 26.0;  // length of an arrow at the frame's edge
constexpr double kInset = 10.0;    // distance of its tip from the edge

void add_edges(Marks& marks, const std::vector<DVec2>& outline, Color color) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        marks.line(outline[i], outline[(i + 1) % outline.size()], kEdge, color);
}

// Half the size of the frame, less an inset on each side.
DVec2 half_frame(const View& view, double inset) {
    return {std::max(0.5 * view.width - inset, 0.0), std::max(0.5 * view.height - inset, 0.0)};
}

// An arrow at the frame's edge towards a target out of view.
void add_pointer(Marks& marks, const View& view, DVec2 target, Color color) {
    const DVec2 half = half_frame(view, marks.pixels(kInset));
    const double beyond = std::max(std::abs(target.x) / half.x, std::abs(target.y) / half.y);
    const DVec2 tip = (1.0 / beyond) * target;
    marks.arrow((1.0 - marks.pixels(kPointer) / length(tip)) * tip, tip, color);
}

// True if the box overlaps the frame; if not, adds an arrow towards it.
bool show_or_point(Marks& marks, const View& view, const Box& box, Color color) {
    const DVec2 half = half_frame(view, 0.0);
    if (Box{view.to_world(-half), view.to_world(half)}.overlaps(box)) return true;
    add_pointer(marks, view, view.to_pixels(box.center()), color);
    return false;
}

void add_region(Marks& marks, const View& view, std::span<const DVec2> corners, Color color) {
    if (!show_or_point(marks, view, box_around(corners), color)) return;
    std::vector<DVec2> outline;
    for (const DVec2 corner : corners) outline.push_back(view.to_pixels(corner));
    add_edges(marks, outline, color);
}

void add_body(Marks& marks, const View& view, const World& world, BodyId body, Color color) {
    const Box box = box_of(world, body);
    if (box.is_empty() || !show_or_point(marks, view, box, color)) return;
    const Pose pose = world.state(body).pose;
    for (const ShapeId shape : world.shapes(body))
        add_edges(marks, pixel_outline(view, world.shape(shape), pose), color);
}

}  // namespace

void add_marking(Layer& layer, const View& view, const World& world, const Marking& marking, const Colors& colors) {
    Marks marks(layer, view, colors.background);
    for (const std::array<DVec2, 4>& region : marking.regions) add_region(marks, view, region, colors.marked);
    for (const BodyId body : marking.bodies)
        if (world.is_valid(body)) add_body(marks, view, world, body, colors.marked);
}

}  // namespace tumble::render
