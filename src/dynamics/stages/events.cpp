#include "dynamics/stages/events.hpp"

#include <algorithm>
#include <tuple>

#include "debug/check.hpp"
#include "dynamics/contacts/collide_contact.hpp"

namespace tumble {

namespace {

// The id of a contact's shape, which may have been destroyed. The index of a destroyed shape is not used again before
// its contacts end, so that its generation is one less than that of the next owner.
ShapeId id_of(const ShapeStore& shapes, std::uint32_t index) {
    ShapeId id = shapes.ids.at(index);
    TUMBLE_CHECK((shapes[index].is_live || id.generation > 0));
    if (!shapes[index].is_live) --id.generation;
    return id;
}

SensorEvent sensor_event(const Simulation& simulation, ProxyPair pair, bool a_is_sensor) {
    TUMBLE_CHECK(pair.a < pair.b);
    const ShapeId a = id_of(simulation.shapes, pair.a), b = id_of(simulation.shapes, pair.b);
    return a_is_sensor ? SensorEvent{a, b} : SensorEvent{b, a};
}

SensorEvent sensor_event(const Simulation& simulation, const Contact& contact) {
    return sensor_event(simulation, contact.shapes, contact.kind == ContactKind::sensor_a);
}

ContactBegin contact_begin(const Simulation& simulation, const Contact& contact) {
    return {id_of(simulation.shapes, contact.shapes.a), id_of(simulation.shapes, contact.shapes.b),
            contact.approach.point, contact.approach.normal, contact.approach.speed};
}

// True if the solver applied an impulse at the watched point, or continuous collision stopped a body at it.
bool is_struck(const Contact& contact) {
    if (contact.watched < 0) return false;
    if (contact.is_touching && !contact.was_touching) return true;
    return contact.watched < contact.manifold.point_count && contact.applied[contact.watched].normal > 0.0f;
}

// At most once per collision: afterwards no point is watched.
bool is_hit(const Simulation& simulation, const Contact& contact) {
    return is_struck(contact) && !contact.was_hit && contact.approach.speed >= simulation.settings.tuning.hit_speed;
}

void end_watch(Contact& contact, bool was_hit) {
    contact.was_hit = was_hit;
    contact.watched = -1;
}

void report_hit(Simulation& simulation, Contact& contact) {
    TUMBLE_CHECK(contact.watched < 2);
    const bool hits = is_hit(simulation, contact);
    end_watch(contact, hits);
    if (!hits) return;
    const ContactBegin hit = contact_begin(simulation, contact);
    simulation.events.contact_hits.push_back({hit.shape_a, hit.shape_b, hit.point, hit.normal, hit.approach_speed});
}

void report_begin(Simulation& simulation, const Contact& contact) {
    if (contact.kind == ContactKind::solid)
        simulation.events.contact_begins.push_back(contact_begin(simulation, contact));
    else
        simulation.events.sensor_begins.push_back(sensor_event(simulation, contact));
}

void report_end(Simulation& simulation, const Contact& contact) {
    if (contact.kind == ContactKind::solid)
        simulation.events.contact_ends.push_back(
            {id_of(simulation.shapes, contact.shapes.a), id_of(simulation.shapes, contact.shapes.b)});
    else
        simulation.events.sensor_ends.push_back(sensor_event(simulation, contact));
}

// Skips a sensor whose overlap cannot have changed: a dynamic body is among the two, and neither moves. Static and
// kinematic bodies may have been moved by set_transform(), which sense_contact() finds by comparing poses.
void update_sensor(const Simulation& simulation, Contact& contact) {
    const BodyStore& bodies = simulation.bodies;
    const bool may_sleep = bodies.is_dynamic(contact.body_a) || bodies.is_dynamic(contact.body_b);
    const bool may_change =
        !may_sleep || contact.is_new || bodies.is_active(contact.body_a) || bodies.is_active(contact.body_b);
    if (may_change) sense_contact(contact, bodies, simulation.shapes);
}

// A body that continuous collision stopped touches from this step on, although its pair was collided before it moved.
void begin_impacts(Simulation& simulation) {
    for (const ProxyPair pair : simulation.scratch->impacts) {
        Contact* const found = simulation.contacts.find(pair);
        if (!found || found->is_touching) continue;
        TUMBLE_CHECK(found->kind == ContactKind::solid);
        Contact* const one[] = {found};
        collide_contacts(one, simulation.bodies, simulation.shapes,
                         StepAhead{simulation.settings.duration, {}, {}, false});
        found->is_touching = found->chain_state != ChainState::crossing;
    }
}

bool has_acted(const Contact& contact) {
    const auto acts = [](const PointImpulse& impulse) { return impulse.normal != 0.0f || impulse.tangent != 0.0f; };
    return acts(contact.applied[0]) || acts(contact.applied[1]);
}

int nearest_point(const Manifold& manifold, const ManifoldPoint& to) {
    TUMBLE_CHECK(manifold.point_count > 0);
    if (manifold.point_count == 1) return 0;
    const auto distance_sq = [&](int i) { return length_sq(manifold.points[i].anchor_a - to.anchor_a); };
    return distance_sq(1) < distance_sq(0) ? 1 : 0;
}

// Adds the impulses of an impact to those of a contact, whose normal may differ. Their sum stays the same.
void add_impulses(Contact& contact, const Impact& impact) {
    const Vec2 normal = contact.manifold.normal, tangent = -perp(normal);
    const Vec2 impact_normal = impact.manifold.normal, impact_tangent = -perp(impact_normal);
    for (int i = 0; i < impact.manifold.point_count; ++i) {
        const Vec2 impulse = impact.applied[i].normal * impact_normal + impact.applied[i].tangent * impact_tangent;
        PointImpulse& sum = contact.applied[nearest_point(contact.manifold, impact.manifold.points[i])];
        sum.normal += dot(impulse, normal);
        sum.tangent += dot(impulse, tangent);
    }
}

// What a contact shows of an impact: it touches in this step, although its shapes may part again. It has the manifold
// of the first impact, unless the solver pushed its shapes too. Of several impacts the fastest counts for its approach,
// and all for its impulses.
void show_impact(Contact& contact, Impact& impact) {
    TUMBLE_CHECK(contact.kind == ContactKind::solid);
    TUMBLE_CHECK(contact.shapes.a == impact.shapes.a);
    TUMBLE_CHECK(contact.shapes.b == impact.shapes.b);
    impact.is_shown = true;
    if (impact.manifold.point_count == 0) return;
    if (contact.manifold.point_count == 0 || !has_acted(contact)) {
        contact.manifold = impact.manifold;
        contact.impulses[0] = contact.impulses[1] = {};
        contact.reference.invalidate();
    }
    add_impulses(contact, impact);
    contact.is_touching = true;
    contact.watched = 0;
    if (contact.is_new || impact.approach.speed >= contact.approach.speed) contact.approach = impact.approach;
}

// A body that touched a sensor during the step and does not overlap it at the end has entered and left it.
void report_sensor_crossings(Simulation& simulation) {
    for (const ProxyPair pair : simulation.scratch->sensor_crossings) {
        const Contact* const contact = simulation.contacts.find(pair);
        if (contact && contact->is_touching) continue;
        TUMBLE_CHECK(simulation.shapes[pair.a].is_sensor != simulation.shapes[pair.b].is_sensor);
        const SensorEvent event = sensor_event(simulation, pair, simulation.shapes[pair.a].is_sensor);
        simulation.events.sensor_begins.push_back(event);
        simulation.events.sensor_ends.push_back(event);
    }
}

// Adds a contact for each impact of shapes that have none: they are apart when the step starts and when it ends.
void add_contacts_of_impacts(Simulation& simulation) {
    std::vector<ProxyPair>& pairs = simulation.scratch->impacts;
    pairs.clear();
    for (const Impact& impact : simulation.scratch->ordered_impacts.impacts) {
        if (simulation.broad.has_pair(impact.shapes)) continue;
        simulation.broad.add_pair(impact.shapes);
        simulation.kept_shapes.push_back(impact.shapes.a);
        pairs.push_back(impact.shapes);
    }
    std::sort(pairs.begin(), pairs.end());
    simulation.contacts.add(pairs, simulation.bodies, simulation.shapes, simulation.settings.tuning);
}

// The impacts of shapes that had no contact in show_impacts().
void show_late_impacts(Simulation& simulation) {
    std::vector<Impact>& impacts = simulation.scratch->ordered_impacts.impacts;
    std::erase_if(impacts, [](const Impact& impact) { return impact.is_shown || impact.manifold.point_count == 0; });
    if (impacts.empty()) return;
    add_contacts_of_impacts(simulation);
    show_impacts(simulation);
}

// True if the contact is to be reported, or is a sensor's. Otherwise ends its step.
bool has_changed(const Simulation& simulation, Contact& contact) {
    if (contact.kind != ContactKind::solid || contact.is_touching != contact.was_touching) return true;
    if (is_hit(simulation, contact)) return true;
    end_watch(contact, false);
    return false;
}

// Finds the contacts to report, and counts all.
void find_changed_contacts(Simulation& simulation) {
    constexpr std::size_t kLeastReported = 512;  // in a chunk: about 3 us of work
    std::vector<Contact>& contacts = simulation.contacts.all();
    std::vector<ContactCounts>& counts = simulation.scratch->chunks.contact_counts;
    counts.assign(simulation.crew.chunk_count(contacts.size(), kLeastReported), {});
    simulation.scratch->chunks.found.fill_by_chunk(simulation.crew, contacts.size(), kLeastReported,
                                                   [&](const Chunk& chunk, std::vector<std::uint32_t>& changed) {
                                                       ContactCounts own;
                                                       for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
                                                           prefetch_after(contacts, i, 1);
                                                           const int shown = shown_points(contacts[i]);
                                                           own.contacts += shown > 0;
                                                           own.points += static_cast<std::size_t>(shown);
                                                           if (has_changed(simulation, contacts[i]))
                                                               changed.push_back(static_cast<std::uint32_t>(i));
                                                       }
                                                       TUMBLE_CHECK(chunk.index < counts.size());
                                                       counts[chunk.index] = own;
                                                   });
    simulation.contact_counts = {simulation.sleeping.contact_count(), simulation.sleeping.point_count()};
    for (const ContactCounts& own : counts) {
        simulation.contact_counts.contacts += own.contacts;
        simulation.contact_counts.points += own.points;
    }
}

void report_change(Simulation& simulation, Contact& contact) {
    if (contact.kind != ContactKind::solid) update_sensor(simulation, contact);
    report_hit(simulation, contact);
    if (contact.is_touching == contact.was_touching) return;
    if (contact.is_touching)
        report_begin(simulation, contact);
    else
        report_end(simulation, contact);
    contact.was_touching = contact.is_touching;
}

}  // namespace

void show_impacts(Simulation& simulation) {
    for (Impact& impact : simulation.scratch->ordered_impacts.impacts)
        if (Contact* const contact = simulation.contacts.find(impact.shapes)) show_impact(*contact, impact);
}

void clear(StepEvents& events) {
    events.contact_begins.clear();
    events.contact_ends.clear();
    events.contact_hits.clear();
    events.sensor_begins.clear();
    events.sensor_ends.clear();
    events.broken_joints.clear();
    events.fell_asleep.clear();
}

void report_removal(Simulation& simulation, Contact& contact) {
    report_hit(simulation, contact);
    if (contact.is_touching && !contact.was_touching) report_begin(simulation, contact);
    if (contact.is_touching || contact.was_touching) report_end(simulation, contact);
}

void report_events(Simulation& simulation) {
    begin_impacts(simulation);
    show_late_impacts(simulation);
    find_changed_contacts(simulation);
    simulation.scratch->chunks.found.for_each(
        [&](std::uint32_t i) { report_change(simulation, simulation.contacts.all()[i]); });
    report_sensor_crossings(simulation);
    // The lists are not in order yet: events of removed contacts were added first, and a sensor event has the sensor
    // first, whatever the order of the pair.
    StepEvents& events = simulation.events;
    const auto is_first = [](const auto& a, const auto& b) {
        return std::tie(a.shape_a, a.shape_b) < std::tie(b.shape_a, b.shape_b);
    };
    std::sort(events.contact_begins.begin(), events.contact_begins.end(), is_first);
    std::sort(events.contact_hits.begin(), events.contact_hits.end(), is_first);
    std::sort(events.contact_ends.begin(), events.contact_ends.end());
    std::sort(events.sensor_begins.begin(), events.sensor_begins.end());
    std::sort(events.sensor_ends.begin(), events.sensor_ends.end());
}

}  // namespace tumble
