#include "reference/box2d/b2_world.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>

#include "reference/box2d/b2_fixtures.hpp"
#include "reference/box2d/b2_types.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::reference {

namespace {

b2BodyType b2_type(BodyType type) {
    switch (type) {
        case BodyType::static_body: return b2_staticBody;
        case BodyType::kinematic_body: return b2_kinematicBody;
        case BodyType::dynamic_body: break;
    }
    return b2_dynamicBody;
}

b2BodyDef body_def(const World& world, BodyId id, const SceneBody& source) {
    const BodyState state = world.state(id);
    b2BodyDef def;
    def.type = b2_type(world.type(id));
    def.position = to_b2(state.pose.position);
    def.angle = static_cast<float>(angle(state.pose.rotation));
    def.linearVelocity = to_b2(state.velocity);
    def.angularVelocity = state.angular_velocity;
    def.linearDamping = static_cast<float>(source.linear_damping);
    def.angularDamping = static_cast<float>(source.angular_damping);
    def.gravityScale = static_cast<float>(source.gravity_scale);
    def.awake = world.is_awake(id);
    def.bullet = source.bullet;
    def.fixedRotation = source.fixed_rotation;
    def.allowSleep = source.allow_sleep;
    return def;
}

// Box2D expects the inertia about the body's origin, and aborts the process if the inertia about the centre of mass is
// not positive.
void set_mass(b2Body& body, const BodyMass& mass) {
    if (!(mass.mass > 0.0f)) return;
    b2MassData data;
    data.mass = mass.mass;
    data.center = to_b2(mass.center);
    data.I = mass.inertia + mass.mass * length_sq(mass.center);
    if (data.I - data.mass * b2Dot(data.center, data.center) > 0.0f || data.I == 0.0f) body.SetMassData(&data);
}

// Box2D has 16 bits of categories: the lowest ones of the filter.
b2Filter b2_filter(const CollisionFilter& filter) {
    b2Filter data;
    data.categoryBits = static_cast<uint16>(filter.category);
    data.maskBits = static_cast<uint16>(filter.mask);
    data.groupIndex = static_cast<int16>(filter.group);
    return data;
}

// With a spring the distance is free, as in tumble.
void set_spring(b2DistanceJointDef& def, const JointSpring& spring) {
    b2LinearStiffness(def.stiffness, def.damping, spring.hertz, spring.damping_ratio, def.bodyA, def.bodyB);
    def.minLength = 0.0f;
    def.maxLength = FLT_MAX;
}

}  // namespace

struct B2World::Impl {
    b2World world;
    float step_duration = 0.0f;
    std::vector<b2Body*> bodies;
    std::map<BodyId, b2Body*> by_id;
    std::vector<std::string> notes;

    Impl(b2Vec2 gravity, float duration) : world(gravity), step_duration(duration) {}

    void add_body(const SceneWorld& built, const Scene& scene, const SceneInstance& instance);
    void add(const RevoluteJointDef& joint);
    void add(const DistanceJointDef& joint);
    void add(const auto&) { note_once("joints other than revolute and distance are left out"); }
    void note_once(const std::string& note) {
        if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
};

void B2World::Impl::add_body(const SceneWorld& built, const Scene& scene, const SceneInstance& instance) {
    const b2BodyDef def = body_def(built.world, instance.id, scene.bodies[instance.source]);
    b2Body* body = world.CreateBody(&def);
    bodies.push_back(body);
    by_id[instance.id] = body;
    for (const ShapeId id : built.world.shapes(instance.id)) {
        const SurfaceMaterial& material = built.world.material(id);
        if (material.rolling_resistance != 0.0f) note_once("rolling resistance is left out");
        if (material.tangent_speed != 0.0f) note_once("tangent speed is left out");
        const b2Fixture* const earlier = body->GetFixtureList();  // new ones are put before it
        if (!add_fixtures(*body, built.world.shape(id), material)) note_once("shapes without area are left out");
        for (b2Fixture* fixture = body->GetFixtureList(); fixture != earlier; fixture = fixture->GetNext())
            fixture->SetFilterData(b2_filter(built.world.filter(id)));
    }
    set_mass(*body, built.world.mass(instance.id));
    if (def.type != b2_staticBody)
        body->SetLinearVelocity(def.linearVelocity);  // of the centre of mass, which set_mass() has moved
}

void B2World::Impl::add(const RevoluteJointDef& joint) {
    b2RevoluteJointDef def;
    def.bodyA = by_id.at(joint.body_a);
    def.bodyB = by_id.at(joint.body_b);
    def.localAnchorA = to_b2(joint.anchor_a);
    def.localAnchorB = to_b2(joint.anchor_b);
    def.referenceAngle = joint.reference_angle;
    def.collideConnected = joint.collide_connected;
    if (joint.motor) {
        def.enableMotor = true;
        def.motorSpeed = joint.motor->speed;
        def.maxMotorTorque = joint.motor->max_torque;
    }
    if (joint.limits) {
        def.enableLimit = true;
        def.lowerAngle = joint.limits->lower;
        def.upperAngle = joint.limits->upper;
    }
    if (joint.spring) note_once("springs of revolute joints are left out");
    world.CreateJoint(&def);
}

void B2World::Impl::add(const DistanceJointDef& joint) {
    b2DistanceJointDef def;
    def.bodyA = by_id.at(joint.body_a);
    def.bodyB = by_id.at(joint.body_b);
    def.localAnchorA = to_b2(joint.anchor_a);
    def.localAnchorB = to_b2(joint.anchor_b);
    def.length = def.minLength = def.maxLength = joint.length;
    if (joint.spring) set_spring(def, *joint.spring);
    if (joint.limits || joint.motor) note_once("limits and motors of distance joints are left out");
    def.collideConnected = joint.collide_connected;
    world.CreateJoint(&def);
}

B2World::B2World(const Scene& scene) {
    const SceneWorld built = build_world(scene);
    impl_ = std::make_unique<Impl>(to_b2(scene.world.gravity), static_cast<float>(1.0 / scene.world.steps_per_second));
    impl_->world.SetAllowSleeping(scene.world.sleeping);
    impl_->world.SetContinuousPhysics(scene.world.continuous);
    for (const SceneInstance& instance : built.bodies) impl_->add_body(built, scene, instance);
    for (const JointId id : built.world.joints())
        std::visit([&](const auto& joint) { impl_->add(joint); }, built.world.joint(id));
}

B2World::~B2World() = default;
B2World::B2World(B2World&&) noexcept = default;
B2World& B2World::operator=(B2World&&) noexcept = default;

void B2World::step(int velocity_iterations, int position_iterations) {
    impl_->world.Step(impl_->step_duration, velocity_iterations, position_iterations);
}

int B2World::body_count() const { return static_cast<int>(impl_->bodies.size()); }

Pose B2World::pose(int body) const {
    const b2Transform& transform = impl_->bodies.at(static_cast<std::size_t>(body))->GetTransform();
    return {{double{transform.p.x}, double{transform.p.y}}, {transform.q.c, transform.q.s}};
}

Vec2 B2World::velocity(int body) const {
    const b2Vec2& velocity = impl_->bodies.at(static_cast<std::size_t>(body))->GetLinearVelocity();
    return {velocity.x, velocity.y};
}

float B2World::angular_velocity(int body) const {
    return impl_->bodies.at(static_cast<std::size_t>(body))->GetAngularVelocity();
}

bool B2World::is_awake(int body) const { return impl_->bodies.at(static_cast<std::size_t>(body))->IsAwake(); }

int B2World::contact_count() const {
    int count = 0;
    for (const b2Contact* contact = impl_->world.GetContactList(); contact; contact = contact->GetNext())
        count += contact->IsTouching();
    return count;
}

float B2World::deepest_overlap() const {
    float deepest = 0.0f;
    for (const b2Contact* contact = impl_->world.GetContactList(); contact; contact = contact->GetNext()) {
        if (!contact->IsTouching()) continue;
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            deepest = std::max(deepest, -manifold.separations[i]);
    }
    return deepest;
}

const std::vector<std::string>& B2World::notes() const { return impl_->notes; }

}  // namespace tumble::reference
