// The private state of World, and the operations that the files of its members share.
//
// Each public call checks its arguments, turns ids into indices, and leaves the physics to src/dynamics. The members of
// World are defined by subject, in world.cpp and world_*.cpp; all of these may call world_impl.cpp.
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
    std::uint32_t diverged_body = kNoBody;  // index of the first body that is not finite
    bool is_restored = false;               // load() or assign() has replaced the state at some time

    void require(BodyId id) const { require_live(simulation.bodies.ids, id, "body"); }
    void require(ShapeId id) const { require_live(simulation.shapes.ids, id, "shape"); }
    void require(JointId id) const { require_live(simulation.joints.ids, id, "joint"); }

    // Adds a shape to a body; the caller updates the body's mass.
    ShapeId attach(BodyId body, const ShapeDef& shape);

    // Computes mass, centre of mass and inertia anew from the body's shapes, or from its own mass if it has one.
    void update_mass(BodyId id);

    // False for a disabled body, and for one whose pose is not finite after a step that diverged.
    bool has_place(BodyId id) const;

    // Adds the proxies of a body's shapes to the broad phase, at its pose and in the layer of its type; a body without
    // a place gets none. remove_proxies() takes them out again. touch_proxies() makes the next step search their pairs
    // anew.
    void add_proxies(BodyId id);
    void remove_proxies(BodyId id);
    void touch_proxies(BodyId id);

    // The gears that a joint is part of, in the order of the joints of its bodies.
    std::vector<JointId> gears_on(JointId id) const;

    // Removes a joint and the gears on it. destroy_joint() wakes its bodies first.
    void remove_joint(JointId id);
    void destroy_joint(JointId id);

    // world_joints.cpp: a gear with body_a and body_b filled in, any other joint as it is. Throws std::invalid_argument
    // for a gear without two different joints that can be geared.
    JointDef with_gear_bodies(const JointDef& joint) const;

    // world_joints.cpp: calls change(def) with the definition of a joint, which must keep its kind, bodies, anchors and
    // collide_connected, and wakes its bodies.
    template <class Change>
    void change_joint(JointId id, Change&& change);

    // world_bodies.cpp: wakes a body and calls change(motion) with its BodyMotion.
    template <class Change>
    void change_motion(BodyId id, Change&& change);

    // world.cpp: World::step() in the memory that simulation.scratch points to.
    void step();

    // world.cpp: the counters of the last step, and the settings of the step from `def`.
    StepCounters count() const;
    void apply_settings();

private:
    template <class IdType>
    void require_live(const IdPool<IdType>& pool, IdType id, const char* kind) const {
        if (pool.is_live(id)) return;
        const std::string text = std::string(kind) + " id is ", object(kind);
        if (id == IdType{}) throw std::invalid_argument(text + "the default one, which is of no " + object);
        const std::string numbers =
            " (index " + std::to_string(id.index) + ", generation " + std::to_string(id.generation) + ")";
        if (pool.was_live(id)) throw std::invalid_argument(text + "stale: the " + object + " was destroyed" + numbers);
        throw std::invalid_argument(text + "unknown: no " + object + " of this world has had it so far" + numbers +
                                    "; it is of another world" +
                                    (is_restored ? ", or of a time after the state that was restored" : ""));
    }
};

}  // namespace tumble
