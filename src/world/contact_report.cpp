#include "world/contact_report.hpp"

namespace tumble {

namespace {

ContactPoint report_point(const Simulation& simulation, const Contact& contact, int index) {
    const ManifoldPoint& from = contact.manifold.points[index];
    ContactPoint point;
    point.body_a = simulation.bodies.ids.at(contact.body_a);
    point.body_b = simulation.bodies.ids.at(contact.body_b);
    point.shape_a = simulation.shapes.ids.at(contact.shapes.a);
    point.shape_b = simulation.shapes.ids.at(contact.shapes.b);
    point.point = simulation.bodies.frames[contact.body_a].pose.position + DVec2(from.anchor_a);
    point.normal = contact.manifold.normal;
    point.feature = from.feature;
    point.separation = from.separation;
    point.normal_impulse = contact.impulses[index].normal;
    point.tangent_impulse = contact.impulses[index].tangent;
    return point;
}

bool are_live(const Simulation& simulation, ProxyPair shapes) {
    return simulation.shapes[shapes.a].is_live && simulation.shapes[shapes.b].is_live;
}

}  // namespace

std::vector<ContactPoint> report_contacts(const Simulation& simulation) {
    std::vector<ContactPoint> points;
    for (const Contact& contact : simulation.contacts.all()) {
        if (!are_live(simulation, contact.shapes)) continue;
        for (int i = 0; i < contact.manifold.point_count; ++i) points.push_back(report_point(simulation, contact, i));
    }
    return points;
}

std::vector<ShapePair> report_pairs(const Simulation& simulation) {
    std::vector<ShapePair> pairs;
    pairs.reserve(simulation.contacts.all().size());
    for (const Contact& contact : simulation.contacts.all())
        if (are_live(simulation, contact.shapes))
            pairs.push_back({simulation.shapes.ids.at(contact.shapes.a), simulation.shapes.ids.at(contact.shapes.b)});
    return pairs;
}

}  // namespace tumble
