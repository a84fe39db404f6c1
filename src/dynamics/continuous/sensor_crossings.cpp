#include "dynamics/continuous/sensor_crossings.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "dynamics/bodies/sweeps.hpp"
#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

bool touched_before(const Simulation& simulation, ProxyPair pair) {
    TUMBLE_CHECK(pair.a < pair.b);
    const Contact* const contact = simulation.contacts.find(pair);
    return contact && contact->was_touching;
}

bool touch_during_step(const Simulation& simulation, ProxyPair pair) {
    const ShapeRecord& a = simulation.shapes[pair.a];
    const ShapeRecord& b = simulation.shapes[pair.b];
    TUMBLE_CHECK(a.is_sensor != b.is_sensor);
    const CastResult touch =
        time_of_impact(a.shape, sweep_of(simulation.bodies, a.body), b.shape, sweep_of(simulation.bodies, b.body));
    return touch.status == CastStatus::hit;
}

}  // namespace

void find_sensor_crossings(Simulation& simulation) {
    std::vector<ProxyPair>& crossings = simulation.scratch->sensor_crossings;
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    std::erase_if(crossings, [&](ProxyPair pair) {
        return !may_collide(simulation, pair) || touched_before(simulation, pair) ||
               !touch_during_step(simulation, pair);
    });
}

}  // namespace tumble
