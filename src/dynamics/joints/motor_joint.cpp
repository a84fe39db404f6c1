#include "dynamics/joints/motor_joint.hpp"

namespace tumble {

void MotorJoint::prepare(const BodyStore& bodies) {
    TUMBLE_CHECK(def_.body_a.index < bodies.frames.size());
    TUMBLE_CHECK(def_.body_b.index < bodies.frames.size());
    const BodyFrame& a = bodies.frames[def_.body_a.index];
    const BodyFrame& b = bodies.frames[def_.body_b.index];
    bodies_ = JointBodies::make(a, def_.anchor_a, b, def_.anchor_b);
    angle_.prepare(a, b, def_.reference_angle);
}

void MotorJoint::update_rows(std::span<const SolverBody> bodies) { block_ = PointBlock::make(bodies_, bodies); }

void MotorJoint::warm_start(std::span<SolverBody> bodies) const {
    apply_row(bodies_, kAngularRow, angular_impulse_, bodies);
    block_.apply(bodies_, impulse_, bodies);
}

// The velocity bias of each row is the spring's rate times the error, less the wanted velocity.
void MotorJoint::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    if (def_.spring && !use_bias) return;  // springs are solved in the pass with bias only, as in JointDrive
    Softness softness;
    float angular_error = 0.0f;
    Vec2 error;
    if (def_.spring) {
        softness = spring_softness(*def_.spring, context.h);
        angular_error = angle_.now(bodies_, bodies);
        error = block_.separation(bodies_, bodies);
    }
    solve_bounded_row(bodies_, kAngularRow, softness, softness.bias_rate * angular_error - def_.angular_velocity,
                      context.h * def_.max_torque, angular_impulse_, bodies);
    solve_bounded_block(bodies_, block_, softness, softness.bias_rate * error - def_.velocity,
                        context.h * def_.max_force, impulse_, bodies);
}

void MotorJoint::take_over(const MotorJoint& old) {
    angle_ = old.angle_;
    impulse_ = old.impulse_;
    angular_impulse_ = old.angular_impulse_;
}

}  // namespace tumble
