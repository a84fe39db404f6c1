#include "dynamics/stages/sensor_crossings.hpp"

#include <algorithm>

#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

bool touched_before(const Simulation& simulation, ProxyPair pair) {
    const Contact* const contact = simulation.contacts.find(pair);
    return contact && contact->was_touching;
}

bool meet_on_the_way(const Simulation& simulation, ProxyPair pair) {
    const ShapeRecord& a = simulation.shapes[pair.a];
    const ShapeRecord& b = simulation.shapes[pair.b];
    const CastResult meeting =
        time_of_impact(a.shape, sweep_of(simulation.bodies, a.body), b.shape, sweep_of(simulation.bodies, b.body));
    return meeting.status == CastStatus::hit;
}

}  // namespace

void find_sensor_crossings(Simulation& simulation) {
    std::vector<ProxyPair>& passes = simulation.scratch.sensor_crossings;
    std::sort(passes.begin(), passes.end());
    passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
    std::erase_if(passes, [&](ProxyPair pair) {
        return !may_collide(simulation, pair) || touched_before(simulation, pair) || !meet_on_the_way(simulation, pair);
    });
}

}  // namespace tumble
