#include "dynamics/stages/sleep.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

bool is_touching(const Contact& contact) { return contact.manifold.point_count > 0; }

// True if some body has been slow for long enough.
bool update_still_times(BodyStore& bodies, const StepSettings& settings) {
    TUMBLE_CHECK(settings.duration > 0.0f);
    bool any_is_ready = false;
    for (std::size_t i = 1; i < bodies.moving.size(); ++i) {
        const SolverBody& body = bodies.solver_bodies[i];
        MovingBody& moving = bodies.moving[i];
        const float speed = length(body.velocity) + std::abs(body.angular_velocity) * moving.motion.reach;
        const bool is_still = speed < settings.tuning.sleep_speed && moving.motion.allow_sleep;
        moving.still_time = is_still ? moving.still_time + settings.duration : 0.0f;
        any_is_ready |= moving.still_time >= settings.tuning.time_to_sleep && (body.flags & kDynamicBody);
    }
    return any_is_ready;
}

// For two bodies that touch or are joined: dynamic ones share an island, a body at rest supports the other's island if
// it can push or pull it, and a moving kinematic one keeps it awake.
void connect(IslandFinder& islands, const BodyStore& bodies, std::uint32_t body_a, std::uint32_t body_b,
             bool has_rows = true) {
    const std::uint32_t a = bodies.frames[body_a].solver_body, b = bodies.frames[body_b].solver_body;
    if (!bodies.is_active(body_a) || !bodies.is_active(body_b)) {
        if (!has_rows) return;
        islands.mark_supported(a);
        islands.mark_supported(b);
    } else if (bodies.is_dynamic(body_a) && bodies.is_dynamic(body_b)) {
        islands.join(a, b);
    } else {
        islands.keep_awake(a);
        islands.keep_awake(b);
    }
}

// True if the body moves and nothing slows it down but what touches it.
bool drifts(const SolverBody& body, const MovingBody& moving, float sleep_speed) {
    const BodyMotion& motion = moving.motion;
    const float path = motion.linear_damping > 0.0f ? 0.0f : length(body.velocity);
    const float turn = motion.angular_damping > 0.0f ? 0.0f : std::abs(body.angular_velocity);
    return path + turn * motion.reach > kDriftPart * sleep_speed;
}

// Keeps islands awake that move through free space. Their drifting bodies count their still time anew: otherwise the
// search for islands would be repeated for ever.
void keep_drifting_awake(Simulation& simulation) {
    BodyStore& bodies = simulation.bodies;
    IslandFinder& islands = simulation.scratch->islands;
    for (std::uint32_t i = 1; i < bodies.moving.size(); ++i)
        if (islands.is_supported(i)) islands.mark_supported(islands.root(i));
    for (std::uint32_t i = 1; i < bodies.moving.size(); ++i) {
        const SolverBody& body = bodies.solver_bodies[i];
        if (!(body.flags & kDynamicBody) || islands.is_supported(islands.root(i))) continue;
        if (!drifts(body, bodies.moving[i], simulation.settings.tuning.sleep_speed)) continue;
        islands.keep_awake(islands.root(i));
        bodies.moving[i].still_time = 0.0f;
    }
}

void find_islands(Simulation& simulation) {
    IslandFinder& islands = simulation.scratch->islands;
    islands.reset(simulation.bodies.solver_bodies.size());
    const std::vector<Contact>& contacts = simulation.contacts.all();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prefetch_after(contacts, i, 1);
        if (is_touching(contacts[i]) && !is_over(simulation, contacts[i]))
            connect(islands, simulation.bodies, contacts[i].body_a, contacts[i].body_b);
    }
    simulation.joints.for_each_awake_pair(
        [&](std::uint32_t a, std::uint32_t b, bool has_rows) { connect(islands, simulation.bodies, a, b, has_rows); });
}

// Removes the contacts of sleeping bodies from those that are solved. A touching contact moves to its island; a pair
// that does not touch is forgotten, unless one of its bodies is active.
void set_contacts_aside(Simulation& simulation) {
    simulation.contacts.keep_if([&](const Contact& contact) {
        const BodyStore& bodies = simulation.bodies;
        if (contact.kind != ContactKind::solid) return true;           // a sleeping body still overlaps its sensor
        if (is_over(simulation, contact)) return true;                 // the next step removes it
        if (contact.chain_state == ChainState::crossing) return true;  // it must go on crossing after it wakes
        const bool sleeps_a = bodies.is_asleep(contact.body_a), sleeps_b = bodies.is_asleep(contact.body_b);
        if (!sleeps_a && !sleeps_b) return true;
        if (bodies.is_active(contact.body_a) || bodies.is_active(contact.body_b)) return true;
        if (is_touching(contact))
            simulation.sleeping.add_contact(bodies.records[sleeps_a ? contact.body_a : contact.body_b].island, contact);
        else
            simulation.broad.remove_pair(contact.shapes);
        return false;
    });
}

bool touches(const SleepingIsland& island, std::uint32_t body) {
    return std::any_of(island.contacts.begin(), island.contacts.end(),
                       [&](const Contact& contact) { return contact.body_a == body || contact.body_b == body; });
}

// Puts the dynamic bodies for which is_chosen(solver body) holds to sleep. They must be whole islands.
template <class IsChosen>
void put_to_sleep(Simulation& simulation, IsChosen&& is_chosen) {
    BodyStore& bodies = simulation.bodies;
    simulation.scratch->sleepers.clear();
    for (std::uint32_t i = 1; i < bodies.moving.size(); ++i)
        if ((bodies.solver_bodies[i].flags & kDynamicBody) && is_chosen(i))
            simulation.scratch->sleepers.push_back({bodies.moving[i].body, simulation.scratch->islands.root(i)});
    std::sort(simulation.scratch->sleepers.begin(), simulation.scratch->sleepers.end());

    // The lowest body of an island comes first and creates it.
    simulation.scratch->island_of_root.assign(bodies.solver_bodies.size(), kNoIsland);
    simulation.scratch->sleeping_joints.clear();
    for (const Sleeper& sleeper : simulation.scratch->sleepers) {
        std::uint32_t& island = simulation.scratch->island_of_root[sleeper.root];
        if (island == kNoIsland) island = simulation.sleeping.add();
        BodyRecord& record = bodies.records[sleeper.body];
        TUMBLE_CHECK(record.island == kNoIsland);
        record.island = island;
        simulation.sleeping[island].bodies.push_back(sleeper.body);
        bodies.put_to_sleep(sleeper.body);
        simulation.scratch->sleeping_joints.insert(simulation.scratch->sleeping_joints.end(), record.joints.begin(),
                                                   record.joints.end());
    }
    simulation.joints.put_to_sleep(simulation.scratch->sleeping_joints);
    set_contacts_aside(simulation);
    simulation.touch_kept();  // a contact that is over must not wake one of them
}

// The bodies whose boxes overlap those of an enabled body, one entry for each pair of shapes. A body that has diverged
// has no boxes.
std::vector<std::uint32_t> bodies_near(const Simulation& simulation, std::uint32_t body) {
    TUMBLE_CHECK(simulation.bodies.records[body].is_enabled);
    std::vector<std::uint32_t> near;
    for (const ShapeId shape : simulation.bodies.records[body].shapes)
        if (simulation.broad.has(shape.index))
            simulation.broad.query(simulation.broad.box(shape.index),
                                   [&](std::uint32_t other) { near.push_back(simulation.shapes[other].body); });
    return near;
}

}  // namespace

void fall_asleep(Simulation& simulation) {
    BodyStore& bodies = simulation.bodies;
    if (!simulation.settings.sleeping) return;
    const bool any_is_ready = update_still_times(bodies, simulation.settings);
    if (simulation.steps_to_island_search > 0) {
        --simulation.steps_to_island_search;
        return;
    }
    if (!any_is_ready) return;
    find_islands(simulation);
    keep_drifting_awake(simulation);
    IslandFinder& islands = simulation.scratch->islands;
    for (std::uint32_t i = 1; i < bodies.moving.size(); ++i)
        if (bodies.moving[i].still_time < simulation.settings.tuning.time_to_sleep || islands.is_kept_awake(i))
            islands.keep_awake(islands.root(i));
    bool any = false;
    for (std::uint32_t i = 1; i < bodies.moving.size() && !any; ++i)
        any = (bodies.solver_bodies[i].flags & kDynamicBody) && !islands.is_kept_awake(islands.root(i));
    if (!any) {
        simulation.steps_to_island_search = kPauseAfterSearch;
        return;
    }
    put_to_sleep(simulation, [&](std::uint32_t i) { return !islands.is_kept_awake(islands.root(i)); });
    for (const Sleeper& sleeper : simulation.scratch->sleepers)
        simulation.events.fell_asleep.push_back(bodies.ids.at(sleeper.body));
}

void put_island_to_sleep(Simulation& simulation, std::uint32_t body) {
    TUMBLE_CHECK(simulation.bodies.is_dynamic(body));
    TUMBLE_CHECK(!simulation.bodies.is_asleep(body));
    simulation.contacts.merge_woken();
    find_islands(simulation);
    const std::uint32_t root = simulation.scratch->islands.root(simulation.bodies.frames[body].solver_body);
    put_to_sleep(simulation, [&](std::uint32_t i) { return simulation.scratch->islands.root(i) == root; });
}

void wake_joint(Simulation& simulation, JointId id) {
    for (const BodyId body : simulation.joints.bodies(id))
        if (!simulation.bodies.records[body.index].is_enabled || simulation.bodies.is_asleep(body.index)) return;
    simulation.joints.wake(id);
}

void wake(Simulation& simulation, std::uint32_t body) {
    BodyStore& bodies = simulation.bodies;
    if (!bodies.is_asleep(body)) {
        bodies.moving[bodies.frames[body].solver_body].still_time = 0.0f;
        return;
    }
    TUMBLE_CHECK(bodies.records[body].island != kNoIsland);
    const SleepingIsland island = simulation.sleeping.take(bodies.records[body].island);
    for (const std::uint32_t sleeper : island.bodies) {
        BodyRecord& record = bodies.records[sleeper];
        record.island = kNoIsland;
        bodies.wake(sleeper);
        for (const ShapeId shape : record.shapes) simulation.broad.touch(shape.index);
        for (const JointId joint : record.joints) wake_joint(simulation, joint);
    }
    simulation.contacts.add_woken(island.contacts);
}

void wake_with_neighbors(Simulation& simulation, std::uint32_t body) {
    BodyStore& bodies = simulation.bodies;
    if (bodies.is_dynamic(body)) return wake(simulation, body);
    if (!bodies.records[body].is_enabled) return;
    for (const JointId id : bodies.records[body].joints)
        for (const BodyId joined : simulation.joints.bodies(id)) wake(simulation, joined.index);
    for (const std::uint32_t other : bodies_near(simulation, body))
        if (bodies.is_asleep(other) && touches(simulation.sleeping[bodies.records[other].island], body))
            wake(simulation, other);
}

void wake_overlapping(Simulation& simulation, std::uint32_t body) {
    if (!simulation.bodies.records[body].is_enabled) return;
    for (const std::uint32_t other : bodies_near(simulation, body))
        if (simulation.bodies.is_asleep(other)) wake(simulation, other);
}

bool touch_in_sleep(const Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b) {
    const std::uint32_t island_a = simulation.bodies.records[body_a].island;
    const std::uint32_t island = island_a != kNoIsland ? island_a : simulation.bodies.records[body_b].island;
    if (island == kNoIsland) return false;
    const std::vector<Contact>& contacts = simulation.sleeping.all()[island].contacts;
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return (contact.body_a == body_a && contact.body_b == body_b) ||
               (contact.body_a == body_b && contact.body_b == body_a);
    });
}

void merge_sleeping_islands(Simulation& simulation, std::uint32_t body_a, std::uint32_t body_b) {
    const std::uint32_t kept = simulation.bodies.records[body_a].island;
    const std::uint32_t dissolved = simulation.bodies.records[body_b].island;
    TUMBLE_CHECK(kept != kNoIsland);
    TUMBLE_CHECK(dissolved != kNoIsland);
    if (kept == dissolved) return;
    const SleepingIsland other = simulation.sleeping.take(dissolved);
    SleepingIsland& island = simulation.sleeping[kept];
    for (const std::uint32_t body : other.bodies) simulation.bodies.records[body].island = kept;
    island.bodies.insert(island.bodies.end(), other.bodies.begin(), other.bodies.end());
    for (const Contact& contact : other.contacts) simulation.sleeping.add_contact(kept, contact);
    std::sort(island.bodies.begin(), island.bodies.end());
}

void put_new_body_to_sleep(Simulation& simulation, std::uint32_t body) {
    TUMBLE_CHECK(simulation.bodies.is_dynamic(body));
    TUMBLE_CHECK(simulation.bodies.records[body].joints.empty());
    const std::uint32_t island = simulation.sleeping.add();
    simulation.sleeping[island].bodies.push_back(body);
    simulation.bodies.records[body].island = island;
    simulation.bodies.put_to_sleep(body);
}

}  // namespace tumble
