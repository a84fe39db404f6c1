// The rigid-body world: definitions in, ids out, one fixed step at a time.
//
// The stepper is a soft-step solver in sub-steps (Catto 2024, "Solver2D"; constants and their reasons in
// src/dynamics/constants.hpp). Equal calls give equal bits: across runs, compilers, instruction sets and build types.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "tumble/body.hpp"
#include "tumble/events.hpp"
#include "tumble/id.hpp"
#include "tumble/joint.hpp"
#include "tumble/math.hpp"

namespace tumble {

struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};      // m/s^2
    float steps_per_second = 60.0f;  // > 0
    int substeps = 4;                // >= 1
    bool sleeping = true;            // whether bodies at rest fall asleep
    bool continuous = true;          // whether fast bodies are kept from passing through thin ones
};

// What the last step did; times are wall clock.
struct StepCounters {
    int bodies = 0;        // all live bodies
    int awake_bodies = 0;  // of those that can sleep: dynamic ones
    int sleeping_islands = 0;
    int contacts = 0;  // pairs with at least one manifold point, those of sleeping bodies too
    int contact_points = 0;
    int joints = 0;
    int colors = 0;  // of the constraint graph
    double pairs_ms = 0.0;
    double narrow_ms = 0.0;
    double solve_ms = 0.0;
    double step_ms = 0.0;
};

// One contact point after a step, to be drawn, tested or written to a file.
struct ContactPoint {
    BodyId body_a;
    BodyId body_b;
    ShapeId shape_a;
    ShapeId shape_b;
    DVec2 point;  // world, half way between the surfaces
    Vec2 normal;  // from A to B
    std::uint32_t feature = 0;
    float separation = 0.0f;      // m, negative inside
    float normal_impulse = 0.0f;  // N s, accumulated over the last sub-step
    float tangent_impulse = 0.0f;
};

// Two shapes whose boxes overlap; most such pairs do not touch.
struct ShapePair {
    ShapeId a;
    ShapeId b;
};

// Bodies fall asleep together: an island is a set of dynamic bodies that touch or are joined, and it sleeps once all of
// it has been slower than 0.05 m/s for half a second. Asleep it costs nothing. It wakes when something awake touches
// it, when one of its bodies is given a velocity, a force, a shape or a joint, and when what it leans on moves or goes.
//
// Calls with a stale or foreign id, with values that are not finite or out of range throw std::invalid_argument with
// the value printed, and leave the world as it was.
class World {
public:
    explicit World(const WorldDef& def = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    BodyId create_body(const BodyDef& def);
    void destroy_body(BodyId id);  // with its shapes and joints
    ShapeId add_shape(BodyId body, const ShapeDef& def);
    JointId create_joint(const JointDef& def);
    void destroy_joint(JointId id);

    // Gives a joint other limits, motors, springs or anchors, between steps: another kind or other bodies are refused.
    // What carries load goes on carrying it.
    void set_joint(JointId id, const JointDef& def);

    // Advances by one step. Throws SimulationDiverged, naming the first body, once a state is no longer finite.
    void step();

    std::uint64_t step_count() const noexcept;
    const WorldDef& def() const noexcept;

    bool is_valid(BodyId id) const noexcept;
    bool is_valid(ShapeId id) const noexcept;
    bool is_valid(JointId id) const noexcept;

    BodyType type(BodyId id) const;
    BodyState state(BodyId id) const;
    BodyMass mass(BodyId id) const;

    void set_velocity(BodyId id, Vec2 velocity, float angular_velocity);

    // A force (N, world axes) at a world point and a torque (N m), during the next step only; an impulse (N s) and an
    // angular impulse (N m s) at once. They act on dynamic bodies, and do nothing to others.
    void apply_force(BodyId id, Vec2 force, DVec2 point);
    void apply_torque(BodyId id, float torque);
    void apply_impulse(BodyId id, Vec2 impulse, DVec2 point);
    void apply_angular_impulse(BodyId id, float impulse);

    // False for a dynamic body that sleeps; others are never asleep. Putting one to sleep stops its whole island, also
    // where falling asleep is off.
    bool is_awake(BodyId id) const;
    void set_awake(BodyId id, bool awake);

    // Live bodies and joints in id order; a body's shapes in the order they were added. The spans hold until the next
    // creation or destruction.
    std::span<const BodyId> bodies() const noexcept;
    std::vector<BodyId> awake_bodies() const;  // those that the next step may move; computed on the call
    std::span<const JointId> joints() const noexcept;
    std::span<const ShapeId> shapes(BodyId id) const;
    const Shape& shape(ShapeId id) const;
    const SurfaceMaterial& material(ShapeId id) const;
    const CollisionFilter& filter(ShapeId id) const;
    bool is_sensor(ShapeId id) const;
    BodyId body(ShapeId id) const;
    const JointDef& joint(JointId id) const;

    // The force with which the joint held its bodies in the last step that it was awake.
    JointReaction reaction(JointId id) const;

    // Where the free motion of a joint was at the start of the last step: the angle of B against A in rad (revolute,
    // weld, motor; of a revolute joint only if it has limits or a spring), the way along the axis in m (prismatic,
    // wheel), or the distance of the anchors in m (distance, mouse).
    float joint_position(JointId id) const;


    // What began, ended, broke and fell asleep in the last step. Holds until the next one.
    const StepEvents& events() const noexcept;

    // Contact points of the last step, in order of shape ids: gaps and places as the step found them, impulses as it
    // left them. Computed on the call: O(contacts).
    std::vector<ContactPoint> contacts() const;

    // The pairs that the last step asked the narrow phase about, in order of shape ids: not those of sleeping bodies.
    // Computed on the call: O(pairs).
    std::vector<ShapePair> candidate_pairs() const;

    // xxHash64 of pose, velocity and sleep flag of the live bodies in id order, as little-endian bytes: equal worlds,
    // equal hashes.
    std::uint64_t state_hash() const;

    const StepCounters& counters() const noexcept;

    // Walks every invariant of stores, tree and graph; throws std::logic_error that names the first one broken.
    void validate() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A pose or a velocity is no longer finite. The world may be read but not stepped.
class SimulationDiverged : public std::runtime_error {
public:
    SimulationDiverged(BodyId body, std::uint64_t step);
    BodyId body;
    std::uint64_t step = 0;
};

}  // namespace tumble
