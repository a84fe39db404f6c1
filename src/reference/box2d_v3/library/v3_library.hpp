// Box2D v3 behind plain functions: its headers and those of 2.4 declare other things by the same names, so that no
// source may include both. The functions are those of a shared library of their own, which exports nothing else;
// without a Box2D v3 (CMake: TUMBLE_BOX2D_V3) absent.cpp takes its place. Lengths in m, everything in float as Box2D
// computes.
#pragma once

#include <cstdint>
#include <span>

#define TUMBLE_V3_API __attribute__((visibility("default")))

namespace tumble::box2d_v3 {

// "3.2.0"; null: Box2D v3 is not there, and no other function may be called.
TUMBLE_V3_API const char* version();

inline constexpr int kMostPoints = 8;

struct Points {
    const float* xy = nullptr;  // x, y in turn
    int count = 0;              // 1 to kMostPoints
    float radius = 0.0f;
};

struct Place {
    float x = 0.0f, y = 0.0f, c = 1.0f, s = 0.0f;
};

struct Nearest {
    float distance = 0.0f;                 // at least 0; 0 means overlap
    float ax = 0, ay = 0, bx = 0, by = 0;  // in the frame of A
    int iterations = 0;
};

// `b_in_a` is the pose of B in the frame of A. A cold start.
TUMBLE_V3_API Nearest distance(const Points& a, const Points& b, const Place& b_in_a, bool use_radii);

struct Hit {
    bool hits = false;
    bool overlaps = false;  // at the start
    float fraction = 1.0f;
};

// Of B by the translation, in the frame of A, to the sum of the radii less linear_slop(), at least linear_slop().
TUMBLE_V3_API Hit cast_shape(const Points& a, const Points& b, const Place& b_in_a, float x, float y);

// In the frame of the shape: a circle, or a polygon without radius.
TUMBLE_V3_API Hit cast_ray(const Points& shape, float origin_x, float origin_y, float x, float y);

struct Motion {
    float center_x = 0, center_y = 0;  // centre of mass, body coordinates
    Place from, to;                    // of the centre of mass
};
TUMBLE_V3_API Hit time_of_impact(const Points& a, const Points& b, const Motion& of_a, const Motion& of_b);

TUMBLE_V3_API float linear_slop();

// ---- Queries to be timed ----

// A list of queries, whose points are converted once. A run answers all, each from two world poses, and returns the sum
// of the answers.
class Queries {
public:
    virtual ~Queries() = default;
    virtual double run() = 0;
};

struct PosedPair {
    Points a;
    Place pose_a;
    Points b;
    Place pose_b;
};
struct MovingPair {
    Points a;
    Motion of_a;
    Points b;
    Motion of_b;
};
struct Ray {
    Points shape;  // a circle, or a polygon without radius
    Place pose;
    float origin_x = 0, origin_y = 0, x = 0, y = 0;  // in the world
};

// The caller deletes the list. Warm: with the cache of the last run.
TUMBLE_V3_API Queries* make_distances(std::span<const PosedPair> pairs, bool is_warm);
TUMBLE_V3_API Queries* make_manifolds(std::span<const PosedPair> pairs);  // of polygons; the numbers of points
TUMBLE_V3_API Queries* make_impacts(std::span<const MovingPair> pairs);
TUMBLE_V3_API Queries* make_rays(std::span<const Ray> rays);

// ---- Worlds ----

struct BodyPlan {
    int type = 0;  // 0 static, 1 kinematic, 2 dynamic
    Place pose;
    float velocity_x = 0, velocity_y = 0, angular_velocity = 0;
    float linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    bool is_awake = true, is_bullet = false, has_fixed_rotation = false, may_sleep = true;
};

struct Surface {
    float friction = 0, restitution = 0, rolling_resistance = 0, tangent_speed = 0;
    std::uint64_t category = 1, mask = ~std::uint64_t{0};
    int group = 0;
};

struct MassPlan {
    float mass = 0, center_x = 0, center_y = 0, inertia = 0;  // about the centre
};

enum class JointKind { revolute, prismatic, distance, weld, wheel };

struct JointPlan {
    JointKind kind = JointKind::revolute;
    int body_a = 0, body_b = 0;
    Place frame_a, frame_b;  // in body coordinates; the motion of a slider or suspension is along the x axis of frame_a
    bool collides = false;   // the two bodies with each other
    float length = 1;        // of a rod or spring
    bool has_limits = false, has_motor = false, has_spring = false;
    float lower = 0, upper = 0;                          // rad or m
    float motor_speed = 0, motor_strength = 0;           // rad/s and N m, or m/s and N
    float hertz = 0, damping_ratio = 0;                  // of a weld: of its point, 0 is rigid
    float angular_hertz = 0, angular_damping_ratio = 0;  // of a weld, 0 is rigid
};

struct World;  // of Box2D
TUMBLE_V3_API World* make_world(float gravity_x, float gravity_y, bool may_sleep, bool is_continuous);
TUMBLE_V3_API void destroy(World* world);
TUMBLE_V3_API int add_body(World* world, const BodyPlan& plan);  // returns 0, 1, 2 ...
// False if Box2D has no such shape: one without area.
TUMBLE_V3_API bool add_shape(World* world, int body, const Points& points, const Surface& surface);
TUMBLE_V3_API void set_mass(World* world, int body, const MassPlan& mass);
TUMBLE_V3_API void add_joint(World* world, const JointPlan& plan);
TUMBLE_V3_API void step(World* world, float seconds, int sub_steps);
TUMBLE_V3_API Place pose_of(const World* world, int body);

}  // namespace tumble::box2d_v3
