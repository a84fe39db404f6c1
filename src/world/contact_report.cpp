#include "world/contact_report.hpp"

#include <algorithm>

#include "dynamics/bodies/divergence.hpp"

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
    point.normal_impulse = contact.applied[index].normal;
    point.tangent_impulse = contact.applied[index].tangent;
    return point;
}

// The contacts with points between live shapes, awake or asleep: of one body, or with kNoBody of all.
std::vector<const Contact*> sorted_contacts(const Simulation& simulation, std::uint32_t body) {
    std::vector<const Contact*> found;
    const auto add = [&](const std::vector<Contact>& contacts) {
        for (const Contact& contact : contacts) {
            const bool is_included = body == kNoBody || contact.body_a == body || contact.body_b == body;
            if (is_included && contact.manifold.point_count > 0 && simulation.is_live(contact.shapes))
                found.push_back(&contact);
        }
    };
    add(simulation.contacts.all());
    add(simulation.contacts.woken());
    for (const SleepingIsland& island : simulation.sleeping.all()) add(island.contacts);
    std::sort(found.begin(), found.end(), [](const Contact* a, const Contact* b) { return a->shapes < b->shapes; });
    return found;
}

}  // namespace

std::vector<ContactPoint> report_contacts(const Simulation& simulation, std::uint32_t body) {
    std::vector<ContactPoint> points;
    for (const Contact* contact : sorted_contacts(simulation, body))
        for (int i = 0; i < contact->manifold.point_count; ++i)
            if (is_shown(*contact, i)) points.push_back(report_point(simulation, *contact, i));
    return points;
}

std::vector<ShapePair> report_pairs(const Simulation& simulation) {
    std::vector<ShapePair> pairs;
    pairs.reserve(simulation.contacts.all().size());
    for (const Contact& contact : simulation.contacts.all())
        if (simulation.is_live(contact.shapes) && !contact.is_new)
            pairs.push_back({simulation.shapes.ids.at(contact.shapes.a), simulation.shapes.ids.at(contact.shapes.b)});
    return pairs;
}

}  // namespace tumble
