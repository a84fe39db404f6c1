#include "dynamics/stages/seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

namespace {

// Normals with a smaller sine between them count as equal: a box that rests on two tiles is tilted by less, by rounding
// and overlap. Larger: fast shapes are deflected at seams.
constexpr float kSameNormal = 1e-4f;

// The contact's normal, out of the ground.
Vec2 ground_normal(const Contact& contact, std::uint32_t moving_shape) {
    return contact.shapes.b == moving_shape ? contact.manifold.normal : -contact.manifold.normal;
}

// A ground contact, with positions relative to the moving body's.
struct GroundPlane {
    const ShapeRecord& ground;
    Rotation rotation;  // of the ground's body
    DVec2 offset;       // of the ground's body, m
    Vec2 normal;        // out of the ground
    double height;      // of the ground's surface along the normal, m
};

GroundPlane ground_plane(const Simulation& simulation, const Contact& contact, std::uint32_t moving_shape) {
    const bool on_a = contact.shapes.b == moving_shape;
    TUMBLE_CHECK((on_a || contact.shapes.a == moving_shape));
    const Manifold& manifold = contact.manifold;
    TUMBLE_CHECK(manifold.point_count > 0);
    const BodyFrame& moving = simulation.bodies.frames[on_a ? contact.body_b : contact.body_a];
    const BodyFrame& ground = simulation.bodies.frames[on_a ? contact.body_a : contact.body_b];
    const Vec2 normal = ground_normal(contact, moving_shape);
    double height = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < manifold.point_count; ++i) {
        const ManifoldPoint& point = manifold.points[i];
        const Vec2 anchor = on_a ? point.anchor_b : point.anchor_a;
        height = std::max(height, double{dot(anchor, normal)} - 0.5 * double{point.separation});
    }
    return {simulation.shapes[on_a ? contact.shapes.a : contact.shapes.b], ground.pose.rotation,
            ground.pose.position - moving.pose.position, normal, height};
}

// Large polygons are not tiles: they count as rising above every plane.
bool rises_above(const GroundPlane& ground, const GroundPlane& plane, double tolerance) {
    const Shape& shape = ground.ground.shape;
    if (shape.vertex_count() > Shape::kInlineVertices) return true;
    const DVec2 normal(plane.normal);
    double highest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < shape.vertex_count(); ++i)
        highest = std::max(highest, dot(ground.offset + rotate(ground.rotation, DVec2(shape.vertex(i))), normal));
    return highest + double{shape.radius()} > plane.height + tolerance;
}

bool is_with_chain(const Simulation& simulation, const Contact& contact) {
    return simulation.shapes[contact.shapes.a].link || simulation.shapes[contact.shapes.b].link;
}

// Removes the manifold of a contact if its ground does not rise above the plane of the other contact.
void remove_if_below(Simulation& simulation, std::uint32_t moving_shape, std::uint32_t index, std::uint32_t other) {
    TUMBLE_CHECK(index < simulation.contacts.all().size());
    TUMBLE_CHECK(other < simulation.contacts.all().size());
    Contact& contact = simulation.contacts.all()[index];
    const Contact& support = simulation.contacts.all()[other];
    if (contact.manifold.point_count == 0 || support.manifold.point_count == 0) return;
    if (is_with_chain(simulation, contact) || is_with_chain(simulation, support)) return;
    const Vec2 normal = ground_normal(contact, moving_shape), normal_of_plane = ground_normal(support, moving_shape);
    if (std::abs(cross(normal, normal_of_plane)) < kSameNormal) return;
    const GroundPlane ground = ground_plane(simulation, contact, moving_shape),
                      plane = ground_plane(simulation, support, moving_shape);
    const double tolerance = double{kRecyclingPart} * double{contact.speculative_distance};
    if (!rises_above(ground, plane, tolerance)) remove_manifold(contact);
}

}  // namespace

void smooth_seams(Simulation& simulation) {
    std::vector<GroundContact>& found = simulation.scratch->ground_contacts;
    std::sort(found.begin(), found.end());
    for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
        while (last < found.size() && found[last].moving_shape == found[first].moving_shape) ++last;
        for (std::size_t i = first; i < last; ++i)
            for (std::size_t other = first; other < last; ++other)
                if (i != other)
                    remove_if_below(simulation, found[first].moving_shape, found[i].contact, found[other].contact);
    }
}

}  // namespace tumble
