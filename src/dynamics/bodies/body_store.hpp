// Bodies: what the narrow phase and the solver's preparation read of each (one cache line), the hot solver bodies of
// those that are awake and may move, and the rest, which only creation, destruction and sleep touch.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dynamics/bodies/id_pool.hpp"
#include "dynamics/bodies/solver_body.hpp"
#include "tumble/body.hpp"

namespace tumble {

// Where a body is, and how heavy. By body index.
struct alignas(64) BodyFrame {
    Pose pose;              // of the body's origin
    DVec2 center;           // centre of mass, world
    Vec2 center_offset;     // centre of mass from the origin, world axes
    float inv_mass = 0.0f;  // 0 if not dynamic
    float inv_inertia = 0.0f;
    std::uint32_t solver_body = kStaticSolverBody;  // the static one if asleep
    BodyType type = BodyType::static_body;          // as it is simulated: static if disabled
    bool locks_x = false;
    bool locks_y = false;

    // What a unit impulse along each axis does to the velocity.
    Vec2 inv_masses() const { return {locks_x ? 0.0f : inv_mass, locks_y ? 0.0f : inv_mass}; }
};
static_assert(sizeof(BodyFrame) == 64);

// How a body moves, as its definition says; what it has no say in is derived.
struct BodyMotion {
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;   // 1/s
    float angular_damping = 0.0f;  // 1/s
    float reach = 0.0f;            // of the farthest point of its shapes from the centre of mass, m
    float smallest_extent = 0.0f;  // of its shapes, m
    bool allow_sleep = true;
};

inline constexpr std::uint32_t kNoIsland = 0xffffffffu;

// What else is known of a body. By body index.
struct BodyRecord {
    BodyMass mass;
    std::optional<BodyMass> own_mass;       // in place of that of its shapes
    BodyType type = BodyType::static_body;  // as defined, disabled or not
    bool is_enabled = true;
    BodyMotion motion;
    std::uint32_t flags = 0;           // BodyFlag
    std::uint32_t island = kNoIsland;  // the sleeping island that holds it
    std::vector<ShapeId> shapes;       // in the order they were added
    std::vector<JointId> joints;       // in order of creation
};

// What the integrator needs of a moving body beside its SolverBody. By solver body.
struct MovingBody {
    std::uint32_t body = 0;  // index
    BodyMotion motion;
    float still_time = 0.0f;  // for how long it has been slow enough to sleep, s
    // By the forces of the next step.
    Vec2 acceleration;                  // m/s^2
    float angular_acceleration = 0.0f;  // rad/s^2

    // Of the centre of mass, as long as nothing is in its way.
    Vec2 free_acceleration(Vec2 gravity) const { return motion.gravity_scale * gravity + acceleration; }
};

class BodyStore {
public:
    BodyStore() : solver_bodies(1), moving(1) {}

    BodyId create(const BodyDef& def);
    void destroy(BodyId id);  // its shapes and joints are gone already

    // Mass, centre of mass and inertia from the sum of the body's shapes. The origin stays where it is, and the
    // velocity of every material point as it was. Reach and smallest extent are those of BodyMotion.
    void set_mass(BodyId id, const BodyMass& mass, float reach, float smallest_extent);

    // Changes what only creation could: keeps the velocity as far as type and locks allow. The mass is to be set anew.
    void set_type(std::uint32_t body, BodyType type);
    void set_enabled(std::uint32_t body, bool enabled);
    void set_flag(std::uint32_t body, BodyFlag flag, bool value);
    void set_motion(std::uint32_t body, const BodyMotion& motion);
    void set_pose(std::uint32_t body, const Pose& pose);

    // A dynamic body leaves or joins the solver bodies; asleep it is at rest. Whose island it is in is the caller's
    // to keep.
    void put_to_sleep(std::uint32_t body);
    void wake(std::uint32_t body);

    bool is_dynamic(std::uint32_t body) const { return frames[body].type == BodyType::dynamic_body; }
    bool is_asleep(std::uint32_t body) const {
        return is_dynamic(body) && frames[body].solver_body == kStaticSolverBody;
    }
    // True if it is among the solver bodies and can push others: dynamic and awake, or kinematic and moving.
    bool is_active(std::uint32_t body) const;
    // Of the one that has fewer: the ground may have thousands.
    const std::vector<JointId>& fewer_joints(std::uint32_t body_a, std::uint32_t body_b) const {
        const std::vector<JointId>&a = records[body_a].joints, &b = records[body_b].joints;
        return a.size() < b.size() ? a : b;
    }
    int awake_dynamic_count() const { return awake_dynamic_count_; }

    IdPool<BodyId> ids;
    std::vector<BodyFrame> frames;          // by body index
    std::vector<BodyRecord> records;        // by body index
    std::vector<SolverBody> solver_bodies;  // [0] is the static one; the others move
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
