#include "dynamics/continuous/ordered_impacts.hpp"

#include <algorithm>
#include <functional>

#include "debug/check.hpp"
#include "dynamics/continuous/impact_response.hpp"
#include "dynamics/continuous/impact_search.hpp"
#include "dynamics/continuous/swept_bodies.hpp"

namespace tumble {

namespace {

// Finds the next impacts of the bodies that an impact gave a new motion. A body that moves little from now on needs no
// search after an inelastic impact: in the next step the solver separates it from what it touches.
void search_again(Simulation& simulation) {
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    for (const std::uint32_t swept : scratch.members)
        if (swept != kNotSwept) update_box(simulation, swept);
    for (const std::uint32_t swept : scratch.members) {
        if (swept == kNotSwept) continue;
        TUMBLE_CHECK(swept < scratch.swept.size());
        note_course(simulation, swept);
        const bool is_lost = scratch.swept[swept].is_off_course && moves_far(simulation, swept);
        if (is_lost || has_bounce(simulation, swept))
            find_next_impact(simulation, swept);
        else
            forget_next_impact(simulation, swept);
    }
}

// True if the other body of a swept body's next impact has had an impact since that was found.
bool has_changed_partner(const Simulation& simulation, std::uint32_t swept) {
    const ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    const NextImpact& next = scratch.next[swept];
    const std::uint32_t a = simulation.shapes[next.shapes.a].body, b = simulation.shapes[next.shapes.b].body;
    const std::uint32_t partner = find_swept(simulation, scratch.swept[swept].body == a ? b : a);
    TUMBLE_CHECK(partner != swept);
    return partner != kNotSwept && scratch.swept[partner].impact_count != next.partner_impacts;
}

}  // namespace

void simulate_impacts(Simulation& simulation) {
    simulation.scratch->impacts.clear();
    simulation.scratch->sensor_crossings.clear();
    clear_swept_bodies(simulation);
    find_fast_bodies(simulation);
    ImpactScratch& scratch = simulation.scratch->ordered_impacts;
    for (std::uint32_t i = 0; i < scratch.swept.size(); ++i) find_next_impact(simulation, i);
    while (!scratch.queue.empty()) {
        std::pop_heap(scratch.queue.begin(), scratch.queue.end(), std::greater<>{});
        const QueuedImpact first = scratch.queue.back();
        scratch.queue.pop_back();
        TUMBLE_CHECK(first.swept < scratch.next.size());
        TUMBLE_CHECK(first.version <= scratch.next[first.swept].version);
        if (first.version != scratch.next[first.swept].version) continue;
        if (has_changed_partner(simulation, first.swept)) {
            find_next_impact(simulation, first.swept);
            continue;
        }
        respond(simulation, NextImpact(scratch.next[first.swept]));
        search_again(simulation);
    }
    TUMBLE_CHECK(scratch.next.size() == scratch.swept.size());
    store_swept_bodies(simulation);
}

}  // namespace tumble
