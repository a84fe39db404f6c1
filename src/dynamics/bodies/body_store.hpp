// Bodies in three arrays by how often they are read: frames (one cache line each, for the narrow phase and the
// preparation of constraints), solver bodies (only of bodies that may move in this step), and records (the rest).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/bodies/id_pool.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "tumble/body.hpp"

namespace tumble {

// The pose and inverse mass of a body. By body index.
struct alignas(64) BodyFrame {
    Pose pose;              // of the body's origin
    DVec2 center;           // centre of mass, world
    Vec2 center_offset;     // centre of mass from the origin, world axes
    float inv_mass = 0.0f;  // 0 if not dynamic
    float inv_inertia = 0.0f;
    std::uint32_t solver_body = kStaticSolverBody;  // index; the static one if asleep
    BodyType type = BodyType::static_body;          // as simulated: static if disabled
    bool locks_x = false;
    bool locks_y = false;

    // The change of velocity per unit impulse along each world axis.
    Vec2 inv_masses() const { return {locks_x ? 0.0f : inv_mass, locks_y ? 0.0f : inv_mass}; }
    // Whether an impulse can change its velocity.
    bool can_move() const { return inv_masses() != Vec2{} || inv_inertia > 0.0f; }
};
static_assert(sizeof(BodyFrame) == 64);

inline constexpr std::uint32_t kNoShape = 0xffffffffu;

// Parameters of a body's motion: from its definition, apart from what follows from its shapes.
struct BodyMotion {
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;   // 1/s
    float angular_damping = 0.0f;  // 1/s
    float reach = 0.0f;            // distance of the farthest point of its shapes from the centre of mass, m
    float smallest_extent = 0.0f;  // of its shapes that are not sensors, m; infinite if there are none
    Vec2 mass_center;              // centre of mass, body coordinates
    bool allow_sleep = true;
    std::uint32_t only_shape = kNoShape;  // index, if it has exactly one: the list of shapes is in other cache lines
};

inline constexpr std::uint32_t kNoIsland = 0xffffffffu;

// All other data of a body. By body index.
struct BodyRecord {
    BodyMass mass;
    std::optional<BodyMass> own_mass;       // replaces the mass of its shapes
    BodyType type = BodyType::static_body;  // as defined, disabled or not
    bool is_enabled = true;
    BodyMotion motion;
    std::uint32_t flags = 0;           // BodyFlag
    std::uint32_t island = kNoIsland;  // the sleeping island that it belongs to
    std::vector<ShapeId> shapes;       // in order of creation
    std::vector<JointId> joints;       // in order of creation
    std::uint64_t user_data = 0;
    std::uint32_t color_seed = 0;  // of the next draw of its contacts (contacts/make_contact.hpp)
};

// How far a body moves in a step if nothing acts on it but forces.
struct FreeMotion {
    Vec2 path;          // of the centre of mass, m
    float turn = 0.0f;  // rad

    friend constexpr bool operator==(const FreeMotion&, const FreeMotion&) = default;
};

// What the integrator reads of a moving body beside its SolverBody. By solver body.
struct MovingBody {
    std::uint32_t body = 0;  // index
    BodyMotion motion;
    float still_time = 0.0f;  // how long it has been slow enough to sleep, s
    Vec2 velocity_rest;       // the part of its velocity below float precision, after free flight, m/s
    // From the forces and torques applied since the last step; they act during the next one.
    Vec2 acceleration;                  // m/s^2
    float angular_acceleration = 0.0f;  // rad/s^2

    // Acceleration of the centre of mass without constraints, m/s^2.
    Vec2 free_acceleration(Vec2 gravity) const { return motion.gravity_scale * gravity + acceleration; }
};

class BodyStore {
public:
    BodyStore() : solver_bodies(1), moving(1) {}

    BodyId create(const BodyDef& def);
    void destroy(BodyId id);  // after its shapes and joints

    // Sets mass, centre of mass and inertia; all zero if the body is not dynamic. The pose of the origin and the
    // velocity of every material point stay the same. `reach` and `smallest_extent` are those of BodyMotion.
    void set_mass(BodyId id, const BodyMass& mass, float reach, float smallest_extent);

    // Each keeps the velocity as far as type and locks allow, but an enabled body starts at rest. After set_type,
    // set_enabled and a change of locks the caller sets the mass again.
    void set_type(std::uint32_t body, BodyType type);
    void set_enabled(std::uint32_t body, bool enabled);
    void set_flag(std::uint32_t body, BodyFlag flag, bool value);
    void set_motion(std::uint32_t body, const BodyMotion& motion);
    void set_pose(std::uint32_t body, const Pose& pose);

    // A dynamic body leaves the solver bodies, or joins them at rest. The caller updates its island.
    void put_to_sleep(std::uint32_t body);
    void wake(std::uint32_t body);

    // Moves the solver bodies: the new i-th one is the old order[i]. `order` is a permutation that begins with the
    // static one.
    void reorder(std::span<const std::uint32_t> order);

    bool is_dynamic(std::uint32_t body) const { return frames[body].type == BodyType::dynamic_body; }
    bool is_asleep(std::uint32_t body) const {
        return is_dynamic(body) && frames[body].solver_body == kStaticSolverBody;
    }
    // True if the body can push others in this step: dynamic and awake, or kinematic and moving.
    bool is_active(std::uint32_t body) const;
    // Of the centre of mass without constraints, as far as locks allow, m/s^2; zero for a solver body that is not
    // dynamic.
    Vec2 free_acceleration(std::uint32_t solver_body, Vec2 gravity) const {
        const std::uint32_t flags = solver_bodies[solver_body].flags;
        return flags & kDynamicBody ? allowed(flags, moving[solver_body].free_acceleration(gravity)) : Vec2{};
    }
    // A bound: a body under a force gains half of what it adds within the step as displacement.
    FreeMotion free_motion(std::uint32_t solver_body, Vec2 gravity, float duration) const {
        const SolverBody& body = solver_bodies[solver_body];
        return {duration * (body.velocity + duration * free_acceleration(solver_body, gravity)),
                duration * body.angular_velocity};
    }
    // The joints of the body that has fewer: the ground may have thousands.
    const std::vector<JointId>& fewer_joints(std::uint32_t body_a, std::uint32_t body_b) const {
        const std::vector<JointId>&a = records[body_a].joints, &b = records[body_b].joints;
        return a.size() < b.size() ? a : b;
    }
    // For passes over the solver bodies that read their frames: loads the frame of a solver body that follows soon.
    void prefetch_frame_after(std::size_t solver_body) const {
        constexpr std::size_t kAhead = 8;
        if (solver_body + kAhead < moving.size()) __builtin_prefetch(&frames[moving[solver_body + kAhead].body]);
    }
    int awake_dynamic_count() const { return awake_dynamic_count_; }

    IdPool<BodyId> ids;
    std::vector<BodyFrame> frames;          // by body index
    std::vector<BodyRecord> records;        // by body index
    std::vector<SolverBody> solver_bodies;  // [0] is the static one
    std::vector<MovingBody> moving;         // by solver body; [0] unused

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.ids, self.frames, self.records, self.solver_bodies, self.moving, self.awake_dynamic_count_);
    }

private:
    void place(std::uint32_t body, BodyType type, Vec2 velocity, float angular_velocity);
    void add_solver_body(std::uint32_t body, Vec2 velocity, float angular_velocity);
    void remove_solver_body(std::uint32_t body);
    void apply_flags(std::uint32_t body);

    int awake_dynamic_count_ = 0;
};

}  // namespace tumble
