// The drive of a free row of a joint: an optional spring, motor and limits. It serves the angle of a hinge, the
// displacement of a slider, the travel of a suspension and the length of a rope.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "debug/check.hpp"
#include "dynamics/rows/joint_row.hpp"
#include "dynamics/rows/row_position.hpp"
#include "tumble/joint.hpp"

namespace tumble {

// The target speed and the largest effort of a motor: rad/s and N m along an angular row, m/s and N along a linear one.
struct DriveMotor {
    float speed = 0.0f;
    float max_effort = 0.0f;
};

inline std::optional<DriveMotor> drive_motor(const std::optional<AngularMotor>& motor) {
    return motor ? std::optional<DriveMotor>({motor->speed, motor->max_torque}) : std::nullopt;
}
inline std::optional<DriveMotor> drive_motor(const std::optional<LinearMotor>& motor) {
    return motor ? std::optional<DriveMotor>({motor->speed, motor->max_force}) : std::nullopt;
}

// The accumulated impulses along the row, N m s or N s.
struct DriveImpulses {
    float spring = 0.0f, motor = 0.0f;  // positive towards greater values
    float lower = 0.0f, upper = 0.0f;   // of the limits, >= 0: towards greater and towards smaller values

    float sum() const { return spring + motor + lower - upper; }
};

enum DrivePart : std::uint32_t { kSpringPart = 1, kMotorPart = 2, kLimitsPart = 4 };

class JointDrive {
public:
    JointDrive() = default;
    JointDrive(const std::optional<JointSpring>& spring, const std::optional<DriveMotor>& motor,
               const std::optional<JointLimits>& limits)
        : spring_(spring), motor_(motor), limits_(limits) {}

    bool is_idle() const { return !spring_ && !motor_ && !limits_; }
    // A bit for each DrivePart that it has.
    std::uint32_t parts() const {
        return (spring_ ? kSpringPart : 0u) | (motor_ ? kMotorPart : 0u) | (limits_ ? kLimitsPart : 0u);
    }
    const std::optional<JointSpring>& spring() const { return spring_; }
    const std::optional<DriveMotor>& motor() const { return motor_; }
    const std::optional<JointLimits>& limits() const { return limits_; }
    bool needs_value() const { return spring_ || limits_; }

    // The accumulated impulse along the row (N m s or N s), positive towards greater values.
    float impulse() const { return impulses_.sum(); }

    const DriveImpulses& impulses() const { return impulses_; }
    void set_impulses(const DriveImpulses& impulses) { impulses_ = impulses; }

    // Solves spring, motor and limits. `position` is that of the row now (row_position.hpp), `rest` the spring's rest
    // position. Springs are solved in the pass with bias only: solved again in the relaxing pass, they would damp
    // twice.
    template <class Row, class Position>
    void solve(const JointBodies& joint, const Row& row, const Position& position, float rest,
               const JointContext& context, bool use_bias, std::span<SolverBody> all) {
        TUMBLE_CHECK(!(impulses_.lower < 0.0f || impulses_.upper < 0.0f));
        LazyPosition lazy(position);
        if (spring_ && use_bias)
            solve_equality(joint, row, spring_softness(*spring_, context.h), lazy.now() - rest, impulses_.spring, all);
        if (motor_) {
            const float value = may_slow_motor(lazy.range(), context.inv_h) ? lazy.now() : lazy.range().lower;
            solve_bounded_row(joint, row, Softness{}, -motor_speed(value, context.inv_h),
                              context.h * motor_->max_effort, impulses_.motor, all);
        }
        if (!limits_) return;
        const float lower = limits_->lower, upper = limits_->upper;
        if (may_reach_limit(joint, row, 1.0f, lazy.range().lower - lower, context, impulses_.lower, all))
            solve_limit(joint, row, 1.0f, lazy.now() - lower, context, use_bias, impulses_.lower, all);
        if (may_reach_limit(joint, row, -1.0f, upper - lazy.range().upper, context, impulses_.upper, all))
            solve_limit(joint, row, -1.0f, upper - lazy.now(), context, use_bias, impulses_.upper, all);
    }

    // Takes over the accumulated impulses of the drive that this one replaces, of each part that this one has.
    void take_over(const JointDrive& old) {
        if (spring_) impulses_.spring = old.impulses_.spring;
        if (motor_) impulses_.motor = old.impulses_.motor;
        if (limits_) impulses_.lower = old.impulses_.lower, impulses_.upper = old.impulses_.upper;
    }

    void forget_impulses() { impulses_ = {}; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.spring_, self.motor_, self.limits_, self.impulses_.spring, self.impulses_.motor,
              self.impulses_.lower, self.impulses_.upper);
    }

private:
    // The motor's target speed, reduced so that a sub-step ends at the limits: a motor that pushed against a limit
    // would only push through its softness.
    float motor_speed(float value, float inv_h) const {
        if (!limits_) return motor_->speed;
        TUMBLE_CHECK(limits_->lower <= limits_->upper);
        const float slowest = std::min((limits_->lower - value) * inv_h, 0.0f);
        const float fastest = std::max((limits_->upper - value) * inv_h, 0.0f);
        return std::clamp(motor_->speed, slowest, fastest);
    }

    // False if motor_speed() is the motor's speed at all positions of the range.
    bool may_slow_motor(const PositionRange& range, float inv_h) const {
        return limits_ && !(motor_->speed >= (limits_->lower - range.lower) * inv_h &&
                            motor_->speed <= (limits_->upper - range.upper) * inv_h);
    }

    std::optional<JointSpring> spring_;
    std::optional<DriveMotor> motor_;
    std::optional<JointLimits> limits_;
    DriveImpulses impulses_;
};

}  // namespace tumble
