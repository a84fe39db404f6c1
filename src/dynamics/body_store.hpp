// Bodies: what the narrow phase and the solver's preparation read of each (one cache line), the hot solver bodies of
// those that move, and the rest, which only creation and destruction touch.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/id_pool.hpp"
#include "dynamics/solver_body.hpp"
#include "tumble/body.hpp"

namespace tumble {

// Where a body is, and how heavy. By body index.
struct alignas(64) BodyFrame {
    Pose pose;              // of the body's origin
    DVec2 center;           // centre of mass, world
    Vec2 center_offset;     // centre of mass from the origin, world axes
    float inv_mass = 0.0f;  // 0 if not dynamic
    float inv_inertia = 0.0f;
    std::uint32_t solver_body = kStaticSolverBody;
    BodyType type = BodyType::static_body;
};
static_assert(sizeof(BodyFrame) == 64);

// What else is known of a body. By body index.
struct BodyRecord {
    BodyMass mass;
    std::vector<ShapeId> shapes;  // in the order they were added
    std::vector<JointId> joints;  // in order of creation
};

// What the integrator needs of a moving body beside its SolverBody. By solver body.
struct MovingBody {
    std::uint32_t body = 0;  // index
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;   // 1/s
    float angular_damping = 0.0f;  // 1/s
};

class BodyStore {
public:
    BodyStore() : solver_bodies(1), moving(1) {}

    BodyId create(const BodyDef& def);
    void destroy(BodyId id);  // its shapes and joints are gone already

    // Mass, centre of mass and inertia from the sum of the body's shapes. The origin stays where it is, and the
    // velocity of every material point as it was.
    void set_mass(BodyId id, const BodyMass& mass);

    bool is_dynamic(std::uint32_t body) const { return frames[body].type == BodyType::dynamic_body; }

    IdPool<BodyId> ids;
    std::vector<BodyFrame> frames;          // by body index
    std::vector<BodyRecord> records;        // by body index
    std::vector<SolverBody> solver_bodies;  // [0] is the static one; the others move
    std::vector<MovingBody> moving;         // by solver body; [0] unused
};

}  // namespace tumble
