// What the facade keeps, shared by the files that define World's members: each public call checks what comes in, turns
// ids into indices, and leaves the physics to the dynamics room.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "dynamics/bodies/divergence.hpp"
#include "dynamics/state/simulation.hpp"
#include "tumble/world.hpp"

namespace tumble {

struct World::Impl {
    WorldDef def;
    Simulation simulation;
    StepCounters counters;
    std::uint64_t step_count = 0;
    std::uint32_t diverged_body = kNoBody;

    void require(BodyId id) const { require_live(simulation.bodies.ids, id, "body"); }
    void require(ShapeId id) const { require_live(simulation.shapes.ids, id, "shape"); }
    void require(JointId id) const { require_live(simulation.joints.ids, id, "joint"); }

    JointDef complete(const JointDef& joint) const;      // a gear with its bodies; throws if it has no two joints
    std::vector<JointId> gears_on(JointId id) const;     // in order of creation
    void remove_joint(JointId id);                       // with its gears
    ShapeId attach(BodyId body, const ShapeDef& shape);  // without its mass
    void touch_shapes(BodyId id);
    void place_shapes(BodyId id);  // proxies where the body is, of its type; none if it is disabled
    void displace_shapes(BodyId id);
    void update_mass(BodyId id);
    void tie(JointId id);
    MovingBody* wake_to_push(BodyId id);  // the body awake, or nullptr if it is not dynamic
    void wake_tied(JointId id);
    template <class Change>
    void change_motion(BodyId id, Change&& change);  // change(BodyMotion&)
    StepCounters count() const;
    void apply_settings();  // of the definition

private:
    template <class IdType>
    static void require_live(const IdPool<IdType>& pool, IdType id, const char* kind) {
        if (pool.is_live(id)) return;
        throw std::invalid_argument(std::string(kind) + " id is stale or foreign: index " + std::to_string(id.index) +
                                    ", generation " + std::to_string(id.generation));
    }
};

}  // namespace tumble
