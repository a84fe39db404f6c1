// The rigid-body world: definitions in, ids out, one fixed step at a time.
//
// The stepper is a soft-step solver in sub-steps (Catto 2024, "Solver2D"; constants and their reasons in
// src/dynamics/constants.hpp). Equal calls give equal bits: across runs, compilers, instruction sets and build types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "tumble/body.hpp"
#include "tumble/counters.hpp"
#include "tumble/events.hpp"
#include "tumble/id.hpp"
#include "tumble/joint.hpp"
#include "tumble/math.hpp"
#include "tumble/query.hpp"

namespace tumble {

struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};      // m/s^2
    float steps_per_second = 60.0f;  // > 0
    int substeps = 4;                // >= 1
    bool sleeping = true;            // whether bodies at rest fall asleep
    bool continuous = true;          // whether fast bodies are kept from passing through thin ones

    // The size of a typical body (m, > 0). The stepper's own lengths, speeds and frequencies are those of things of 1
    // m; they follow the scale s as gravity makes things follow it: lengths by s, speeds by its root, frequencies by
    // the inverse of its root. A world of marbles (0.02) then behaves as one of boulders, at 1 / sqrt(s) times the step
    // rate.
    float scale = 1.0f;
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
    float separation = 0.0f;  // m, negative inside

    // What B got of A in the whole step, N s: along the normal, and along the normal turned clockwise. At rest the
    // points of a body that lies carry its weight times the step, and what an impact stopped shows its momentum.
    float normal_impulse = 0.0f;
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
// No dynamic body moves faster than 400 m/s (times the root of WorldDef::scale), or turns by more than an eighth of a
// turn in a step (half a turn in a sub-step, if it is allowed to turn fast): joints and forces that ask for more are
// not followed further.
//
// Calls with an id that names nothing here (of something destroyed, or of another world: an id does not know its world
// and may happen to name something in this one), with values that are not finite or out of range throw
// std::invalid_argument with the value printed, and leave the world as it was.
class World {
public:
    explicit World(const WorldDef& def = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    BodyId create_body(const BodyDef& def);

    // A body with its shapes, whose velocity is that of the centre of mass of them all. Weighs them once: O(n), where
    // adding n one by one is O(n^2).
    BodyId create_body(const BodyDef& def, std::span<const ShapeDef> shapes);
    void destroy_body(BodyId id);  // with its shapes, its joints and their gears
    ShapeId add_shape(BodyId body, const ShapeDef& def);
    void remove_shape(ShapeId id);
    JointId create_joint(const JointDef& def);
    void destroy_joint(JointId id);  // with the gears on it

    // Gives a joint other limits, motors, springs or anchors, between steps: another kind, other bodies or other joints
    // of a gear are refused. What carries load goes on carrying it.
    void set_joint(JointId id, const JointDef& def);

    // Advances by one step. Throws SimulationDiverged, naming the first body, once a state is no longer finite.
    void step();

    std::uint64_t step_count() const noexcept;
    double time() const noexcept;  // s, of all steps
    const WorldDef& def() const noexcept;

    bool is_valid(BodyId id) const noexcept;
    bool is_valid(ShapeId id) const noexcept;
    bool is_valid(JointId id) const noexcept;

    BodyType type(BodyId id) const;
    BodyState state(BodyId id) const;
    BodyMass mass(BodyId id) const;

    // The definition that would make the body as it is now, all that was set since included.
    BodyDef definition(BodyId id) const;

    // Moves a body to a pose at once: nothing on the way is met, and its velocity stays. Contacts of the new place
    // begin in the next step, those that it has left end there; what overlaps is pushed out. The body wakes, and so
    // does what leant on it, is tied to it or is met by it now.
    void set_transform(BodyId id, const Pose& pose);

    // Of the centre of mass. What is locked stays 0. Static and disabled bodies have none to set: they are refused.
    void set_velocity(BodyId id, Vec2 velocity, float angular_velocity);

    // Gives a body the velocity with which it is at a pose after the next step, if nothing is in its way: for platforms
    // and hands that follow a path. The shorter turn; stop it by set_velocity() once it is there.
    void move_towards(BodyId id, const Pose& pose);

    // Another type: a body that becomes static stops, and what leant on it wakes. Forces of the next step are gone.
    void set_type(BodyId id, BodyType type);

    // A disabled body keeps its place, shapes and joints, but is not part of the world: it does not move, its joints do
    // not hold, nothing meets it and no query sees it. Its velocity is gone when it comes back.
    void set_enabled(BodyId id, bool enabled);
    bool is_enabled(BodyId id) const;

    // How a body moves, as in BodyDef. They wake it.
    void set_locks(BodyId id, BodyLocks locks);
    void set_damping(BodyId id, float linear, float angular);
    void set_gravity_scale(BodyId id, float scale);
    void set_bullet(BodyId id, bool bullet);
    void set_allow_fast_rotation(BodyId id, bool allowed);
    void set_allow_sleep(BodyId id, bool allowed);

    // A mass in place of that of the shapes, or that of the shapes again. Every point keeps its velocity.
    void set_mass(BodyId id, const std::optional<BodyMass>& mass);

    // Another surface or filter, for contacts that exist too. Density counts at once. O(contacts), and wakes the body.
    void set_material(ShapeId id, const SurfaceMaterial& material);
    void set_filter(ShapeId id, const CollisionFilter& filter);

    // Wakes every body.
    void set_gravity(Vec2 gravity);

    // A force (N, world axes) at a world point and a torque (N m), during the next step only; an impulse (N s) and an
    // angular impulse (N m s) at once. They act on dynamic bodies, with the mass of the moment, and do nothing to
    // others.
    void apply_force(BodyId id, Vec2 force, DVec2 point);
    void apply_force(BodyId id, Vec2 force);  // at the centre of mass
    void apply_torque(BodyId id, float torque);
    void apply_impulse(BodyId id, Vec2 impulse, DVec2 point);
    void apply_impulse(BodyId id, Vec2 impulse);  // at the centre of mass
    void apply_angular_impulse(BodyId id, float impulse);

    // False for a dynamic body that sleeps; others are never asleep. Putting one to sleep stops its whole island, also
    // where falling asleep is off.
    bool is_awake(BodyId id) const;
    void set_awake(BodyId id, bool awake);

    // Live bodies and joints in id order; a body's shapes in the order they were added. The spans hold until the next
    // creation or destruction.
    std::span<const BodyId> bodies() const noexcept;
    std::vector<BodyId> awake_bodies() const;  // those that the next step may move; computed on the call

    // The island of each body, [bodies().size()], numbered from 0 by their lowest bodies: dynamic bodies that touch or
    // are joined, awake or asleep. -1 for bodies that have none. Computed on the call: O(bodies + contacts).
    std::vector<int> islands() const;
    std::span<const JointId> joints() const noexcept;
    std::span<const JointId> joints(BodyId id) const;  // in the order they were created
    std::span<const ShapeId> shapes(BodyId id) const;
    const Shape& shape(ShapeId id) const;
    const SurfaceMaterial& material(ShapeId id) const;
    const CollisionFilter& filter(ShapeId id) const;
    bool is_sensor(ShapeId id) const;
    BodyId body(ShapeId id) const;
    const JointDef& joint(JointId id) const;

    // The force with which the joint held its bodies in the last step that it was awake.
    JointReaction reaction(JointId id) const;

    // The points that a joint acts on, one of each body, as they are now; of a gear those of its two joints on their
    // second bodies; none for a filter.
    std::optional<JointAnchors> joint_anchors(JointId id) const;

    // Where the free motion of a joint was at the start of the last step: the angle of B against A in rad (revolute,
    // weld, motor; of a revolute joint only if it has limits or a spring), the way along the axis in m (prismatic,
    // wheel), the distance of the anchors in m (distance, mouse), or that of A's from its wheel (pulley). Of a gear how
    // far it gives: what it keeps less what it should be, in rad or m as its first joint has it.
    float joint_position(JointId id) const;

    // The first shape that a ray from `origin` to `origin + translation` enters, or all of them, the nearest first. A
    // shape that holds the origin is not entered.
    std::optional<CastHit> cast_ray(DVec2 origin, DVec2 translation, const QueryFilter& filter = {}) const;
    std::vector<CastHit> cast_ray_all(DVec2 origin, DVec2 translation, const QueryFilter& filter = {}) const;

    // The first shape that a shape meets on its way by `translation`, without turning. It meets what it overlaps at the
    // start at fraction 0; what it only touches there, if it moves towards it.
    std::optional<CastHit> cast_shape(const Shape& shape, const Pose& pose, DVec2 translation,
                                      const QueryFilter& filter = {}) const;

    // The shapes that a shape overlaps (touching counts where rounding cannot tell), or whose bounding boxes share a
    // point with the box from `lower` to `upper`. In id order.
    std::vector<ShapeId> overlap_shape(const Shape& shape, const Pose& pose, const QueryFilter& filter = {}) const;
    std::vector<ShapeId> overlap_box(DVec2 lower, DVec2 upper, const QueryFilter& filter = {}) const;

    // The shape nearest to a point, no farther than max_distance (m, may be infinite). Inside several, the one that the
    // point is deepest in.
    std::optional<ClosestHit> closest(DVec2 point, double max_distance, const QueryFilter& filter = {}) const;

    // The distance of two bodies, by their nearest solid shapes: O(n log n + n m) for n and m of them.
    BodyDistance distance(BodyId a, BodyId b) const;

    // What began, ended, broke and fell asleep in the last step. Holds until the next one.
    const StepEvents& events() const noexcept;

    // Contact points of the last step, in order of shape ids: gaps and normals as the step found them, points
    // carried along with A, impulses summed over the step. Computed on the call: O(contacts).
    std::vector<ContactPoint> contacts() const;
    std::vector<ContactPoint> contacts(BodyId id) const;  // those of one body

    // The pairs that the last step asked the narrow phase about, in order of shape ids: not those of sleeping bodies.
    // Computed on the call: O(pairs).
    std::vector<ShapePair> candidate_pairs() const;

    // xxHash64 of pose, velocity and sleep flag of the live bodies in id order, as little-endian bytes: equal worlds,
    // equal hashes.
    std::uint64_t state_hash() const;

    const StepCounters& counters() const noexcept;

    // O(bodies).
    WorldMemory memory() const;

    // All that the world is, to go on from: the loaded world steps with the same bits as this one. The bytes are those
    // of this version on every machine (little-endian); their size is about that of memory().
    std::vector<std::byte> save() const;

    // Throws SnapshotError for what is not a whole snapshot of this version.
    static World load(std::span<const std::byte> snapshot);

    // Walks every invariant of stores, tree and graph; throws std::logic_error that names the first one broken.
    void audit() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A snapshot that cannot be loaded: cut short, damaged, or of another version.
class SnapshotError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A pose or a velocity is no longer finite. The world may be read but not stepped.
class SimulationDiverged : public std::runtime_error {
public:
    SimulationDiverged(BodyId body, std::uint64_t step);
    BodyId body;
    std::uint64_t step = 0;
};

}  // namespace tumble
