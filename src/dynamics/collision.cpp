#include "dynamics/collision.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/contacts/collide_contact.hpp"
#include "dynamics/continuous/bounces.hpp"
#include "dynamics/stages/events.hpp"
#include "dynamics/stages/sleep.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

constexpr std::size_t kLeastCollided = 32, kLeastOverlaps = 512;  // in a chunk: about 3 us of work

StepAhead step_ahead(const Simulation& simulation) {
    const StepSettings& settings = simulation.settings;
    return {settings.duration, settings.gravity, simulation.scratch->free_motions, settings.orders_impacts()};
}

// True if the contact has points and one of its bodies is not dynamic.
bool is_on_ground(const BodyStore& bodies, const Contact& contact) {
    return contact.manifold.point_count > 0 &&
           (!bodies.is_dynamic(contact.body_a) || !bodies.is_dynamic(contact.body_b));
}

GroundContact ground_contact(const BodyStore& bodies, const Contact& contact, std::size_t index) {
    return {bodies.is_dynamic(contact.body_a) ? contact.shapes.a : contact.shapes.b, static_cast<std::uint32_t>(index)};
}

// Collides up to eight solid contacts of an array.
void collide_eight(const Simulation& simulation, std::span<Contact* const> eight, const Contact* array,
                   CollidedChunk& chunk) {
    if (eight.empty()) return;
    unsigned apart = 0;
    for (std::size_t i = 0; i < eight.size(); ++i)
        apart |= static_cast<unsigned>(eight[i]->chain_state == ChainState::apart) << i;
    const StepAhead ahead = step_ahead(simulation);
    const unsigned in_full = collide_contacts(eight, simulation.bodies, simulation.shapes, ahead);
    CollisionCounts& counts = chunk.counts;
    counts.pairs += static_cast<std::int64_t>(eight.size());
    for (std::size_t i = 0; i < eight.size(); ++i) {
        Contact& contact = *eight[i];
        const auto index = static_cast<std::size_t>(&contact - array);
        if (is_on_ground(simulation.bodies, contact))
            chunk.grounds.push_back(ground_contact(simulation.bodies, contact, index));
        if (ahead.predicts) counts.bounces += note_bounce(simulation, contact);
        counts.crossings += contact.chain_state == ChainState::crossing;
        if (apart >> i & 1 && contact.chain_state != ChainState::apart)
            chunk.newcomers.push_back(static_cast<std::uint32_t>(index));
        if (!(in_full >> i & 1)) continue;
        ++counts.full;
        counts.iterations += contact.cache.iterations;
    }
}

// Among all contacts, after those that woke were sorted into them.
void find_ground_contacts(Simulation& simulation) {
    const std::vector<Contact>& contacts = simulation.contacts.all();
    std::vector<GroundContact>& grounds = simulation.scratch->ground_contacts;
    grounds.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prefetch_after(contacts, i, 1);
        if (is_on_ground(simulation.bodies, contacts[i]))
            grounds.push_back(ground_contact(simulation.bodies, contacts[i], i));
    }
}

// Collides the solid contacts of an array from the index `first` on. Returns what the chunks found.
std::span<const CollidedChunk> collide_contacts_from(Simulation& simulation, std::vector<Contact>& contacts,
                                                     std::size_t first) {
    Crew& crew = simulation.crew;
    ChunkScratch& scratch = simulation.scratch->chunks;
    const std::size_t count = contacts.size() - first;
    const std::size_t used_chunks = crew.chunk_count(count, kLeastCollided);
    if (scratch.collided.size() < used_chunks) scratch.collided.resize(used_chunks);
    crew.for_each_chunk(count, kLeastCollided, [&](const Chunk& chunk) {
        CollidedChunk& own = scratch.collided[chunk.index];
        own.clear();
        Contact* eight[kLaneCount];
        std::size_t used = 0;
        for (std::size_t i = first + chunk.begin; i < first + chunk.end; ++i) {
            prefetch_reference_after(contacts, i);
            if (contacts[i].kind == ContactKind::solid) eight[used++] = &contacts[i];
            if (used < std::size_t{kLaneCount}) continue;
            collide_eight(simulation, eight, contacts.data(), own);
            used = 0;
        }
        collide_eight(simulation, {eight, used}, contacts.data(), own);
    });
    const std::span<const CollidedChunk> chunks = std::span(scratch.collided).first(used_chunks);
    scratch.newcomers.clear();
    for (const CollidedChunk& own : chunks) {
        simulation.report.collided += own.counts;
        scratch.newcomers.insert(scratch.newcomers.end(), own.newcomers.begin(), own.newcomers.end());
    }
    simulation.scratch->ordered_impacts.bounces.has_candidates |= simulation.report.collided.bounces > 0;
    simulation.chain_crossings.now |= simulation.report.collided.crossings > 0;
    ChainContacts chains = simulation.chain_contacts();
    chains.woken_rounds = scratch.woken_rounds;
    follow_neighbors(chains, contacts, scratch.newcomers);
    return chunks;
}

// True if contacts of shapes that have not moved may end.
bool may_end_anywhere(const Simulation& simulation) {
    return simulation.shapes.has_destroyed() || simulation.filters_changed;
}

// Keeps the contacts that touched in this step, and notes a shape of each, so that a later search ends them.
void keep_touched(Simulation& simulation, ChunkLists<std::uint32_t>& ended) {
    ended.erase_if([&](std::uint32_t i) {
        const Contact& contact = simulation.contacts.all()[i];
        const bool has_touched = contact.kind == ContactKind::solid && contact.is_touching && !contact.is_new;
        if (has_touched) simulation.kept_shapes.push_back(contact.shapes.a);
        return has_touched;
    });
}

const std::vector<ProxyPair>& find_new_pairs(Simulation& simulation) {
    return simulation.broad.find_new_pairs([&](ProxyPair pair) { return may_collide(simulation, pair); },
                                           simulation.crew);
}

// Reports the end of a contact. The caller removes it.
void end_contact(Simulation& simulation, Contact& contact) {
    report_removal(simulation, contact);
    simulation.broad.remove_pair(contact.shapes);
}

// The indices of the contacts that end.
const ChunkLists<std::uint32_t>& find_ended(Simulation& simulation, EndOf which) {
    std::vector<Contact>& contacts = simulation.contacts.all();
    ChunkLists<std::uint32_t>& ended = simulation.scratch->chunks.found;
    const bool may_end_all = may_end_anywhere(simulation);
    const auto add_if_ended = [&](std::size_t i, std::vector<std::uint32_t>& found) {
        prefetch_after(contacts, i, 1);
        const ProxyPair shapes = contacts[i].shapes;
        if (!may_end_all && !simulation.broad.has_moved(shapes.a) && !simulation.broad.has_moved(shapes.b)) return;
        const bool keep =
            simulation.broad.overlap(shapes) && !(simulation.filters_changed && !may_collide(simulation, shapes));
        if (!keep) found.push_back(static_cast<std::uint32_t>(i));
    };
    ended.fill(simulation.crew, contacts.size(), kLeastOverlaps, add_if_ended);
    if (which == EndOf::untouched_contacts) keep_touched(simulation, ended);
    return ended;
}

// Reports the end of contacts. The caller removes them.
void end_each(Simulation& simulation, const ChunkLists<std::uint32_t>& ended) {
    ended.for_each([&](std::uint32_t i) { end_contact(simulation, simulation.contacts.all()[i]); });
}

// Wakes the sleeping bodies of the touching contacts of an array, from the index `first` on. Returns false if there are
// none. The contacts of the islands that wake go to ContactStore::woken(), which may be this array.
bool wake_touched(Simulation& simulation, const std::vector<Contact>& contacts, std::size_t first) {
    if (simulation.sleeping.count() == 0) return false;
    bool any = false;
    const std::size_t end = contacts.size();
    for (std::size_t i = first; i < end; ++i) {
        if (contacts[i].manifold.point_count == 0) continue;
        const std::uint32_t bodies[] = {contacts[i].body_a, contacts[i].body_b};
        for (const std::uint32_t body : bodies) {
            if (!simulation.bodies.is_asleep(body)) continue;
            wake(simulation, body);
            any = true;
        }
    }
    return any;
}

// Makes a round of the contacts in ContactStore::woken() from the index `first` on, and of those that begin where
// bodies woke. A contact ends if one of its bodies was moved while the other slept.
void start_woken_round(Simulation& simulation, std::size_t first) {
    ContactStore& contacts = simulation.contacts;
    contacts.keep_woken_if(first, [&](Contact& contact) {
        const bool keep = simulation.broad.overlap(contact.shapes);
        if (!keep) end_contact(simulation, contact);
        return keep;
    });
    contacts.add_to_woken(find_new_pairs(simulation), simulation.bodies, simulation.shapes, simulation.settings.tuning);
    contacts.sort_woken(first);
    simulation.scratch->chunks.woken_rounds.push_back(static_cast<std::uint32_t>(first));
}

}  // namespace

void find_pairs(Simulation& simulation, EndOf which) {
    simulation.contacts.merge_woken();
    if (!simulation.broad.has_moved() && !may_end_anywhere(simulation)) return;
    const ChunkLists<std::uint32_t>& ended = find_ended(simulation, which);
    const std::vector<ProxyPair>& new_pairs = find_new_pairs(simulation);
    end_each(simulation, ended);
    simulation.contacts.replace(ended, new_pairs, simulation.bodies, simulation.shapes, simulation.settings.tuning);
    simulation.shapes.forget_destroyed();
    simulation.filters_changed = false;
}

void end_contacts(Simulation& simulation, EndOf which) {
    if (!simulation.broad.has_moved() && !may_end_anywhere(simulation)) return;
    const ChunkLists<std::uint32_t>& ended = find_ended(simulation, which);
    end_each(simulation, ended);
    simulation.contacts.remove(ended);
}

void collide_pairs(Simulation& simulation) {
    simulation.chain_crossings = {.before = simulation.chain_crossings.now};
    simulation.scratch->ordered_impacts.bounces.has_candidates = false;
    simulation.scratch->chunks.woken_rounds.clear();
    std::vector<GroundContact>& grounds = simulation.scratch->ground_contacts;
    grounds.clear();
    for (const CollidedChunk& own : collide_contacts_from(simulation, simulation.contacts.all(), 0))
        grounds.insert(grounds.end(), own.grounds.begin(), own.grounds.end());
}

void collide_woken(Simulation& simulation) {
    std::vector<Contact>& woken = simulation.contacts.woken();
    TUMBLE_CHECK(woken.empty());
    bool any = wake_touched(simulation, simulation.contacts.all(), 0);
    if (!any) return;
    for (std::size_t first = 0; any;) {
        start_woken_round(simulation, first);
        collide_contacts_from(simulation, woken, first);
        const std::size_t next = woken.size();
        any = wake_touched(simulation, woken, first);
        first = next;
    }
    simulation.contacts.merge_woken();
    find_ground_contacts(simulation);
}

}  // namespace tumble
