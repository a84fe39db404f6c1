#include "reference/box2d_v3/library/v3_joints.hpp"

#include "reference/box2d_v3/library/v3_types.hpp"

namespace tumble::box2d_v3 {

namespace {

// What the definitions of all joints have.
template <class Def>
Def with_frames(Def def, b2BodyId a, b2BodyId b, const JointPlan& plan) {
    def.base.bodyIdA = a;
    def.base.bodyIdB = b;
    def.base.localFrameA = transform_of(plan.frame_a);
    def.base.localFrameB = transform_of(plan.frame_b);
    def.base.collideConnected = plan.collides;
    return def;
}

// What those with one free motion have.
template <class Def>
Def with_motion(Def def, const JointPlan& plan) {
    def.enableLimit = plan.has_limits;
    def.enableMotor = plan.has_motor;
    def.motorSpeed = plan.motor_speed;
    def.enableSpring = plan.has_spring;
    def.hertz = plan.hertz;
    def.dampingRatio = plan.damping_ratio;
    return def;
}

}  // namespace

void create_joint(b2WorldId world, b2BodyId a, b2BodyId b, const JointPlan& plan) {
    switch (plan.kind) {
        case JointKind::revolute: {
            b2RevoluteJointDef def = with_motion(with_frames(b2DefaultRevoluteJointDef(), a, b, plan), plan);
            def.lowerAngle = plan.lower;
            def.upperAngle = plan.upper;
            def.maxMotorTorque = plan.motor_strength;
            b2CreateRevoluteJoint(world, &def);
            return;
        }
        case JointKind::prismatic: {
            b2PrismaticJointDef def = with_motion(with_frames(b2DefaultPrismaticJointDef(), a, b, plan), plan);
            def.lowerTranslation = plan.lower;
            def.upperTranslation = plan.upper;
            def.maxMotorForce = plan.motor_strength;
            b2CreatePrismaticJoint(world, &def);
            return;
        }
        case JointKind::wheel: {
            b2WheelJointDef def = with_motion(with_frames(b2DefaultWheelJointDef(), a, b, plan), plan);
            def.lowerTranslation = plan.lower;
            def.upperTranslation = plan.upper;
            def.maxMotorTorque = plan.motor_strength;
            b2CreateWheelJoint(world, &def);
            return;
        }
        case JointKind::distance: {
            b2DistanceJointDef def = with_motion(with_frames(b2DefaultDistanceJointDef(), a, b, plan), plan);
            def.length = plan.length;
            def.enableSpring = plan.has_spring || plan.has_limits;  // without it Box2D keeps the length
            if (plan.has_limits) {
                def.minLength = plan.lower;
                def.maxLength = plan.upper;
            }
            def.maxMotorForce = plan.motor_strength;
            b2CreateDistanceJoint(world, &def);
            return;
        }
        case JointKind::weld: {
            b2WeldJointDef def = with_frames(b2DefaultWeldJointDef(), a, b, plan);
            def.linearHertz = plan.hertz;
            def.linearDampingRatio = plan.damping_ratio;
            def.angularHertz = plan.angular_hertz;
            def.angularDampingRatio = plan.angular_damping_ratio;
            b2CreateWeldJoint(world, &def);
            return;
        }
    }
}

}  // namespace tumble::box2d_v3
