// Worlds of Box2D v3.
#include <cstddef>
#include <vector>

#include "reference/box2d_v3/library/v3_joints.hpp"
#include "reference/box2d_v3/library/v3_library.hpp"
#include "reference/box2d_v3/library/v3_types.hpp"

namespace tumble::box2d_v3 {

struct World {
    b2WorldId id{};
    std::vector<b2BodyId> bodies{};
};

namespace {

b2ShapeDef shape_def(const Surface& surface) {
    b2ShapeDef def = b2DefaultShapeDef();
    def.material.friction = surface.friction;
    def.material.restitution = surface.restitution;
    def.material.rollingResistance = surface.rolling_resistance;
    def.material.tangentSpeed = surface.tangent_speed;
    def.filter.categoryBits = surface.category;
    def.filter.maskBits = surface.mask;
    def.filter.groupIndex = surface.group;
    return def;
}

}  // namespace

World* make_world(float gravity_x, float gravity_y, bool may_sleep, bool is_continuous) {
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = {gravity_x, gravity_y};
    def.enableSleep = may_sleep;
    def.enableContinuous = is_continuous;
    return new World{b2CreateWorld(&def), {}};
}

void destroy(World* world) {
    if (world == nullptr) return;
    b2DestroyWorld(world->id);
    delete world;
}

int add_body(World* world, const BodyPlan& plan) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = plan.type == 0 ? b2_staticBody : plan.type == 1 ? b2_kinematicBody : b2_dynamicBody;
    def.position = {plan.pose.x, plan.pose.y};
    def.rotation = {plan.pose.c, plan.pose.s};
    def.linearVelocity = {plan.velocity_x, plan.velocity_y};
    def.angularVelocity = plan.angular_velocity;
    def.linearDamping = plan.linear_damping;
    def.angularDamping = plan.angular_damping;
    def.gravityScale = plan.gravity_scale;
    def.isAwake = plan.is_awake;
    def.isBullet = plan.is_bullet;
    def.motionLocks.angularZ = plan.has_fixed_rotation;
    def.enableSleep = plan.may_sleep;
    world->bodies.push_back(b2CreateBody(world->id, &def));
    return static_cast<int>(world->bodies.size()) - 1;
}

bool add_shape(World* world, int body, const Points& points, const Surface& surface) {
    const b2BodyId id = world->bodies[static_cast<std::size_t>(body)];
    const b2ShapeDef def = shape_def(surface);
    const auto at = vertices_of(points);
    if (points.count == 1) {
        const b2Circle circle = circle_of(points);
        b2CreateCircleShape(id, &def, &circle);
    } else if (points.count == 2 && points.radius > 0.0f) {
        const b2Capsule capsule{at[0], at[1], points.radius};
        b2CreateCapsuleShape(id, &def, &capsule);
    } else if (points.count == 2) {
        const b2Segment segment{at[0], at[1]};
        b2CreateSegmentShape(id, &def, &segment);
    } else {
        const b2Hull hull = b2ComputeHull(at.data(), points.count);
        if (hull.count < 3) return false;
        const b2Polygon polygon = b2MakePolygon(&hull, points.radius);
        b2CreatePolygonShape(id, &def, &polygon);
    }
    return true;
}

void set_mass(World* world, int body, const MassPlan& mass) {
    b2Body_SetMassData(world->bodies[static_cast<std::size_t>(body)],
                       {mass.mass, {mass.center_x, mass.center_y}, mass.inertia});
}

void add_joint(World* world, const JointPlan& plan) {
    const auto body = [&](int index) { return world->bodies[static_cast<std::size_t>(index)]; };
    create_joint(world->id, body(plan.body_a), body(plan.body_b), plan);
}

void step(World* world, float seconds, int sub_steps) { b2World_Step(world->id, seconds, sub_steps); }

Place pose_of(const World* world, int body) {
    const b2WorldTransform pose = b2Body_GetTransform(world->bodies[static_cast<std::size_t>(body)]);
    return {static_cast<float>(pose.p.x), static_cast<float>(pose.p.y), pose.q.c, pose.q.s};
}

}  // namespace tumble::box2d_v3
