#include "world/contact_report.hpp"

#include <algorithm>
#include <utility>

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

// Collects contacts with points between live shapes: of one body, or with kNoBody of all.
class Collector {
public:
    Collector(const Simulation& simulation, std::uint32_t body) : simulation_(simulation), body_(body) {}

    void add(const Contact& contact) {
        const bool is_included = body_ == kNoBody || contact.body_a == body_ || contact.body_b == body_;
        if (is_included && contact.manifold.point_count > 0 && simulation_.is_live(contact.shapes))
            found_.push_back(&contact);
    }
    void add(const std::vector<Contact>& contacts) {
        for (const Contact& contact : contacts) add(contact);
    }
    void add_all() {
        add(simulation_.contacts.all());
        add(simulation_.contacts.woken());
        for (const SleepingIsland& island : simulation_.sleeping.all()) add(island.contacts);
    }

    // Those of one body, from the shapes whose boxes overlap those of its own. The contacts of a sleeping island are
    // not sorted, so that all of its contacts are looked at.
    void add_near() {
        add_island(body_);
        for (const ShapeId shape : simulation_.bodies.records[body_].shapes)
            if (simulation_.broad.has(shape.index)) add_near(shape.index);
        std::sort(islands_.begin(), islands_.end());
        islands_.erase(std::unique(islands_.begin(), islands_.end()), islands_.end());
        for (const std::uint32_t island : islands_) add(simulation_.sleeping.all()[island].contacts);
        add(simulation_.contacts.woken());
    }

    std::vector<const Contact*> take() { return std::move(found_); }

private:
    void add_near(std::uint32_t shape) {
        simulation_.broad.query(simulation_.broad.box(shape), [&](std::uint32_t other) {
            if (other == shape) return;
            if (const Contact* contact = simulation_.contacts.find(make_pair_of(shape, other))) add(*contact);
            add_island(simulation_.shapes[other].body);
        });
    }
    void add_island(std::uint32_t body) {
        const std::uint32_t island = simulation_.bodies.records[body].island;
        if (island != kNoIsland) islands_.push_back(island);
    }

    const Simulation& simulation_;
    std::uint32_t body_;
    std::vector<const Contact*> found_;
    std::vector<std::uint32_t> islands_;
};

// The contacts with points between live shapes, awake or asleep: of one body, or with kNoBody of all.
std::vector<const Contact*> sorted_contacts(const Simulation& simulation, std::uint32_t body) {
    Collector collector(simulation, body);
    // A box that was moved since the last step is not where its contacts are, and the boxes of a contact that was kept
    // are apart.
    if (body == kNoBody || simulation.broad.has_moved() || !simulation.kept_shapes.empty())
        collector.add_all();
    else
        collector.add_near();
    std::vector<const Contact*> found = collector.take();
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
