// World: a rigid-body simulation in two dimensions with a fixed time step.
//
//   World world;
//   const BodyId ground = world.create_body({.type = BodyType::static_body});
//   world.add_shape(ground, {.shape = make_box({40, 1})});
//   const BodyId ball = world.create_body({.pose = {{0, 5}, {}}});
//   world.add_shape(ball, {.shape = make_circle(0.5f)});
//   for (int i = 0; i < 120; ++i) world.step();
//   const BodyState state = world.state(ball);
//
// Units are m, kg, s and rad; y is up and counter-clockwise is positive. Each step solves soft constraints in several
// sub-steps (Catto 2024, "Solver2D"). The same calls give the same bits: in every run, with every supported compiler,
// instruction set, build type and number of threads.
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
#include "tumble/step_memory.hpp"
#include "tumble/threads.hpp"
#include "tumble/world_def.hpp"

namespace tumble {

// A world of rigid bodies. It owns bodies, shapes and joints, and refers to them by ids.
//
// Sleep. Dynamic bodies that touch or are joined form an island. An island falls asleep once all of its bodies have
// been slower than 0.05 m/s for 0.5 s, each times the square root of WorldDef::scale; if other bodies have been slow
// for so long but could not fall asleep, up to three steps later. An island that touches and is joined to no body at
// rest stays awake while a body without damping moves in it. A sleeping island costs nothing in a step. It wakes when
// an awake body touches it; when one of its bodies gets a velocity, a force, a joint to an awake body or, with
// contacts, a shape; and when a body that it rests on is moved, changed or destroyed.
//
// Speed limits. A step clamps the speed of dynamic bodies to 400 m/s times the square root of WorldDef::scale, and
// their rotation to 1/8 turn in a step (1/2 turn in a sub-step with BodyDef::allow_fast_rotation), whatever forces and
// joints act on them. world_limits() computes these limits.
//
// Errors. A call with an id of a destroyed object, with a value that is not finite, or with a value out of its range
// throws std::invalid_argument; the message names the argument and prints its value, and the world does not change. An
// id does not record its world: an id of another world throws too, unless it equals an id of this one.
class World {
public:
    // An empty world.
    explicit World(const WorldDef& def = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // ---- Stepping ----

    // Advances the world by one step of 1 / steps_per_second. Throws SimulationDiverged in the step after which a pose
    // or a velocity is not finite, and in every later call.
    void step();

    // The same step, which works in `memory` in place of memory of the world's own.
    void step(StepMemory& memory);

    std::uint64_t step_count() const noexcept;  // the steps made so far
    double time() const noexcept;               // s: step_count() / steps_per_second
    const WorldDef& def() const noexcept;       // with the gravity that was set last

    // Changes WorldDef::threads.
    void set_threads(const Threads& threads);

    // Sets the gravity, m/s^2, and wakes every body.
    void set_gravity(Vec2 gravity);

    // ---- Bodies ----

    // Creates a body without shapes.
    BodyId create_body(const BodyDef& def);

    // Creates a body with shapes. BodyDef::velocity is the velocity of the centre of mass of all shapes. This computes
    // the mass once, O(n) for n shapes; adding n shapes one by one is O(n^2).
    BodyId create_body(const BodyDef& def, std::span<const ShapeDef> shapes);

    // Destroys a body with its shapes, its joints and the gears on them. Wakes the bodies that touch it or are joined
    // to it.
    void destroy_body(BodyId id);

    // True if the id refers to a body of this world that is not destroyed.
    bool is_valid(BodyId id) const noexcept;

    // All bodies in id order. Valid until the next body is created or destroyed.
    std::span<const BodyId> bodies() const noexcept;

    // The bodies that the next step may move, in id order: awake dynamic ones and moving kinematic ones. O(bodies).
    std::vector<BodyId> awake_bodies() const;

    BodyType type(BodyId id) const;
    BodyState state(BodyId id) const;  // pose of the origin, velocity of the centre of mass
    BodyMass mass(BodyId id) const;
    Energy energy(BodyId id) const;  // 0 if the body is not dynamic

    // Of all dynamic bodies. O(bodies).
    Energy energy() const;
    DVec2 momentum() const;  // kg m/s

    // The states of all bodies in the order of bodies(), copied into the caller's arrays. Throws std::invalid_argument
    // if an array is neither empty nor has bodies().size() entries. O(bodies), without allocation.
    void read_states(const BodyStateArrays& out) const;

    // The velocity (m/s) of the point of the body that is at a world point (m): that of the centre of mass plus
    // angular velocity x offset.
    Vec2 velocity_at(BodyId id, DVec2 point) const;

    // The definition that would create the body as it is now, with everything that was set since its creation.
    BodyDef definition(BodyId id) const;

    // Moves a body to a pose at once, without collisions on the path; its velocity does not change. Contacts begin and
    // end in the next step, which also pushes overlapping shapes apart. Wakes the body, the bodies that touch it or are
    // joined to it, and the sleeping bodies at the new pose.
    void set_transform(BodyId id, const Pose& pose);

    // Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s, counter-clockwise positive), and
    // wakes the body. Components locked by BodyLocks stay 0. Throws for a static or disabled body.
    void set_velocity(BodyId id, Vec2 velocity, float angular_velocity);

    // Sets the velocity with which an unobstructed body reaches a pose in the next step, by the shorter rotation. For
    // kinematic bodies that follow a path. The velocity stays: stop the body by set_velocity() when it has arrived.
    // Throws for a static or disabled body.
    void move_towards(BodyId id, const Pose& pose);

    // Changes the type. A body that becomes static loses its velocity; forces applied since the last step are lost.
    // Wakes the body and the bodies that touch it or are joined to it.
    void set_type(BodyId id, BodyType type);

    // A disabled body keeps its pose, shapes and joints, but does not move, collide or appear in queries, and its
    // joints do not act. It has velocity 0 when it is enabled again. Wakes the bodies that touch it or are joined to
    // it.
    void set_enabled(BodyId id, bool enabled);
    bool is_enabled(BodyId id) const;

    // Change the members of BodyDef with these names. Each call wakes the body.
    void set_locks(BodyId id, BodyLocks locks);
    void set_damping(BodyId id, float linear, float angular);  // 1/s, >= 0
    void set_gravity_scale(BodyId id, float scale);
    void set_bullet(BodyId id, bool bullet);
    void set_allow_fast_rotation(BodyId id, bool allowed);
    void set_allow_sleep(BodyId id, bool allowed);

    // Sets a mass in place of the mass of the shapes, or with std::nullopt restores the mass of the shapes. The
    // velocity of every material point stays the same. Wakes the body.
    void set_mass(BodyId id, const std::optional<BodyMass>& mass);

    // Forces (N) and torques (N m) act during the next step only; impulses (N s) and angular impulses (N m s) change
    // the velocity at once. Vectors are in world axes, points in world coordinates (m), rotation is counter-clockwise
    // positive. They wake a dynamic body and have no effect on other bodies.
    void apply_force(BodyId id, Vec2 force, DVec2 point);
    void apply_force(BodyId id, Vec2 force);  // at the centre of mass
    void apply_torque(BodyId id, float torque);
    void apply_impulse(BodyId id, Vec2 impulse, DVec2 point);
    void apply_impulse(BodyId id, Vec2 impulse);  // at the centre of mass
    void apply_angular_impulse(BodyId id, float impulse);

    // False for a sleeping dynamic body. Static, kinematic and disabled bodies never sleep.
    bool is_awake(BodyId id) const;

    // Wakes the island of a body or puts it to sleep with velocity 0, also if WorldDef::sleeping is false. Has no
    // effect on bodies that are not dynamic.
    void set_awake(BodyId id, bool awake);

    // The island of each body, [bodies().size()]: numbered from 0 in the order of their first bodies, awake or asleep;
    // -1 for bodies that are not dynamic. O(bodies + contacts).
    std::vector<int> islands() const;

    // ---- Shapes ----

    // Adds a shape to a body and updates the body's mass. Wakes a sleeping body whose island has contacts.
    ShapeId add_shape(BodyId body, const ShapeDef& def);

    // Removes a shape from its body and updates the body's mass. Wakes the body and the bodies that touch it or are
    // joined to it.
    void remove_shape(ShapeId id);

    // True if the id refers to a shape of this world that is not destroyed.
    bool is_valid(ShapeId id) const noexcept;

    // The shapes of a body in the order they were added. Valid until a shape of the body is added or removed.
    std::span<const ShapeId> shapes(BodyId id) const;

    // References are valid until the next shape is added or removed.
    const Shape& shape(ShapeId id) const;  // in body coordinates
    const SurfaceMaterial& material(ShapeId id) const;
    const CollisionFilter& filter(ShapeId id) const;
    bool is_sensor(ShapeId id) const;
    BodyId body(ShapeId id) const;

    // Changes the material of a shape, also for its present contacts, and the body's mass. Wakes the body and its
    // neighbors. O(contacts).
    void set_material(ShapeId id, const SurfaceMaterial& material);

    // Changes the filter of a shape; contacts that it excludes end in the next step. Wakes the body and its neighbors.
    void set_filter(ShapeId id, const CollisionFilter& filter);

    // ---- Joints (joint.hpp) ----

    // Creates a joint between two different bodies. A gear takes its bodies from its two joints. Wakes the bodies if
    // one of them is in awake_bodies(); a joint of sleeping bodies sleeps with them.
    JointId create_joint(const JointDef& def);

    // Destroys a joint and the gears on it, and wakes its bodies.
    void destroy_joint(JointId id);

    // Change one member of a joint's definition, and wake its bodies; cheaper than set_joint(). Throw
    // std::invalid_argument for a joint whose kind has no such member. set_motor_speed() (rad/s or m/s) throws also for
    // a joint without a motor; set_motor() gives the joint a motor of a largest torque (N m: revolute, wheel) or force
    // (N: prismatic, distance). set_target() sets the world point (m) to which a mouse joint pulls B.
    void set_motor_speed(JointId id, float speed);
    void set_motor(JointId id, float speed, float max_effort);
    void set_limits(JointId id, const std::optional<JointLimits>& limits);
    void set_spring(JointId id, const std::optional<JointSpring>& spring);
    void set_target(JointId id, DVec2 target);

    // Changes the parameters of a joint: limits, motor, spring, anchors... The kind, the bodies and the joints of a
    // gear must stay the same. The accumulated impulses are kept, so that a loaded joint stays loaded. Wakes the
    // bodies.
    void set_joint(JointId id, const JointDef& def);

    // True if the id refers to a joint of this world that is not destroyed.
    bool is_valid(JointId id) const noexcept;

    // All joints in id order, and the joints of a body in order of their creation. Valid until the next joint is
    // created or destroyed.
    std::span<const JointId> joints() const noexcept;
    std::span<const JointId> joints(BodyId id) const;

    // Whether the bodies of the joint, and of the joints of a gear, are all awake and enabled. A step solves the awake
    // joints, and those that it wakes.
    bool is_awake(JointId id) const;

    const JointDef& joint(JointId id) const;

    // The force and torque of the joint on body B in the last step in which it was awake: see JointReaction.
    JointReaction reaction(JointId id) const;

    // The world points where a joint acts on its two bodies, at their present poses. Of a gear the anchors of its two
    // joints on their second bodies; none for a filter joint.
    std::optional<JointAnchors> joint_anchors(JointId id) const;

    // The position of the joint's free motion at the start of the last step in which it was awake:
    //   revolute, weld, motor   angle of B - angle of A - reference_angle, rad; 0 for a revolute joint without
    //                           limits and spring
    //   prismatic, wheel        displacement of B's anchor from A's along the axis, m
    //   distance, mouse         distance of the anchors, m
    //   pulley                  distance of A's anchor from its wheel, m
    //   gear                    motion_a + ratio * motion_b - its value at creation, rad or m
    //   filter                  0
    float joint_position(JointId id) const;

    // The position and speed of the joint's free motion in the present state, after the step. The position is that of
    // joint_position(), except for revolute joints without limits and spring: their angle is in [-pi, pi], as whole
    // turns are not counted. For a gear the position is still that at the start of the step.
    JointMotion joint_motion(JointId id) const;

    // ---- User data ----

    // A number that the caller keeps with a body, a shape or a joint, such as the address or the index of an object of
    // its own. It is part of definitions and snapshots, and has no effect on the simulation and on state_hash().
    std::uint64_t user_data(BodyId id) const;
    std::uint64_t user_data(ShapeId id) const;
    std::uint64_t user_data(JointId id) const;
    void set_user_data(BodyId id, std::uint64_t data);
    void set_user_data(ShapeId id, std::uint64_t data);
    void set_user_data(JointId id, std::uint64_t data);

    // ---- Queries (query.hpp) ----

    // The first shape that a ray from `origin` to `origin + translation` (m) enters, or all of them, sorted by
    // fraction. A shape that contains the origin is not hit.
    std::optional<CastHit> cast_ray(DVec2 origin, DVec2 translation, const QueryFilter& filter = {}) const;
    std::vector<CastHit> cast_ray_all(DVec2 origin, DVec2 translation, const QueryFilter& filter = {}) const;

    // The first shape that `shape` touches when it moves from `pose` by `translation` (m) without rotation. A shape
    // that it overlaps at the start is hit at fraction 0; one that it touches there only if it moves towards it.
    std::optional<CastHit> cast_shape(const Shape& shape, const Pose& pose, DVec2 translation,
                                      const QueryFilter& filter = {}) const;

    // The shapes that `shape` at `pose` overlaps, in id order. Shapes that touch within rounding are included.
    std::vector<ShapeId> overlap_shape(const Shape& shape, const Pose& pose, const QueryFilter& filter = {}) const;

    // The shapes whose bounding boxes overlap or touch the box from `lower` to `upper` (m), in id order.
    std::vector<ShapeId> overlap_box(DVec2 lower, DVec2 upper, const QueryFilter& filter = {}) const;

    // The shape nearest to a point, if one is at most max_distance (m, may be infinite) away. Inside several shapes,
    // the one in which the point is deepest.
    std::optional<ClosestHit> closest(DVec2 point, double max_distance, const QueryFilter& filter = {}) const;

    // The signed distance of two bodies: that of their nearest pair of solid shapes. O(n log n + n m) for n and m
    // shapes.
    BodyDistance distance(BodyId a, BodyId b) const;

    // ---- Reports of the last step ----

    // What began, ended, broke and fell asleep in the last step. Valid until the next step.
    const StepEvents& events() const noexcept;

    // The contact points after the last step in order of shape ids, also of sleeping bodies and of shapes that touched
    // only within the step. Separations and normals are those at the start of the step, points have moved with A,
    // impulses are sums over the step. O(contacts).
    std::vector<ContactPoint> contacts() const;
    std::vector<ContactPoint> contacts(BodyId id) const;  // of one body

    // The pairs of shapes that the narrow phase collided in the last step, in order of shape ids; pairs of sleeping
    // bodies are not collided. O(pairs).
    std::vector<ShapePair> candidate_pairs() const;

    // xxHash64 of poses, velocities and sleep flags of the bodies in id order, as little-endian bytes. Worlds in equal
    // states have equal hashes on every machine.
    std::uint64_t state_hash() const;

    // Counts and times of the last step.
    const StepCounters& counters() const noexcept;

    // The memory that the world has allocated. O(bodies).
    WorldMemory memory() const;

    // ---- Snapshots ----

    // The whole state as bytes: a world loaded from them makes the same steps as this one, bit for bit. The format is
    // little-endian on every machine and readable by this version only; the size is about that of memory().
    std::vector<std::byte> save() const;

    // The world of a snapshot, with one thread. Throws SnapshotError for bytes that are not a whole snapshot of this
    // version.
    static World load(std::span<const std::byte> snapshot);

    // Makes this the world that `other` is: both make the same steps from now on. Ids of `other` are valid in it. It
    // keeps its threads, and uses the memory that it has: for a small world it takes a tenth of the time of load().
    void assign(const World& other);

    // ---- Diagnostics ----

    // Walks all invariants of the world's data structures. Throws std::logic_error, which names the first broken one,
    // for a defect of this library.
    void audit() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Makes one step of each world, each of which must be there once, on several threads: better than steps on several
// threads if there are more worlds than threads. A world whose own WorldDef::threads are more than one uses these too.
// If steps throw, the other worlds still make theirs, and the exception of the first world is thrown.
void step_all(std::span<World* const> worlds, const Threads& threads = {.count = 0});

// A snapshot that cannot be loaded: incomplete, damaged, or of another version.
class SnapshotError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A pose or a velocity is not finite. The world can be read, but not stepped.
class SimulationDiverged : public std::runtime_error {
public:
    // The message has the name of the body, by default its index.
    SimulationDiverged(BodyId body, std::uint64_t step, const std::string& name = {});
    BodyId body;             // the one with the lowest id that is not finite
    std::uint64_t step = 0;  // step_count() after the step
};

}  // namespace tumble
