// The drive of a free row of a joint: an optional spring, motor and limits. It serves the angle of a hinge, the
// displacement of a slider, the travel of a suspension and the length of a rope.
#pragma once

#include <algorithm>
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

class JointDrive {
public:
    JointDrive() = default;
    JointDrive(const std::optional<JointSpring>& spring, const std::optional<DriveMotor>& motor,
               const std::optional<JointLimits>& limits)
        : spring_(spring), motor_(motor), limits_(limits) {}

    bool is_idle() const { return !spring_ && !motor_ && !limits_; }
    bool needs_value() const { return spring_ || limits_; }

    // The accumulated impulse along the row (N m s or N s), positive towards greater values.
    float impulse() const { return spring_impulse_ + motor_impulse_ + lower_impulse_ - upper_impulse_; }

    // Solves spring, motor and limits. `position` is that of the row now (row_position.hpp), `rest` the spring's rest
    // position. Springs are solved in the pass with bias only: solved again in the relaxing pass, they would damp
    // twice.
    template <class Row, class Position>
    void solve(const JointBodies& joint, const Row& row, const Position& position, float rest,
               const JointContext& context, bool use_bias, std::span<SolverBody> all) {
        TUMBLE_CHECK(!(lower_impulse_ < 0.0f || upper_impulse_ < 0.0f));
        LazyPosition lazy(position);
        if (spring_ && use_bias)
            solve_equality(joint, row, spring_softness(*spring_, context.h), lazy.now() - rest, spring_impulse_, all);
        if (motor_) {
            const float value = may_slow_motor(lazy.range(), context.inv_h) ? lazy.now() : lazy.range().lower;
            solve_bounded_row(joint, row, Softness{}, -motor_speed(value, context.inv_h),
                              context.h * motor_->max_effort, motor_impulse_, all);
        }
        if (!limits_) return;
        const float lower = limits_->lower, upper = limits_->upper;
        if (may_reach_limit(joint, row, 1.0f, lazy.range().lower - lower, context, lower_impulse_, all))
            solve_limit(joint, row, 1.0f, lazy.now() - lower, context, use_bias, lower_impulse_, all);
        if (may_reach_limit(joint, row, -1.0f, upper - lazy.range().upper, context, upper_impulse_, all))
            solve_limit(joint, row, -1.0f, upper - lazy.now(), context, use_bias, upper_impulse_, all);
    }

    // Takes over the accumulated impulses of the drive that this one replaces, of each part that this one has.
    void take_over(const JointDrive& old) {
        if (spring_) spring_impulse_ = old.spring_impulse_;
        if (motor_) motor_impulse_ = old.motor_impulse_;
        if (limits_) lower_impulse_ = old.lower_impulse_, upper_impulse_ = old.upper_impulse_;
    }

    void forget_impulses() { spring_impulse_ = motor_impulse_ = lower_impulse_ = upper_impulse_ = 0.0f; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.spring_, self.motor_, self.limits_, self.spring_impulse_, self.motor_impulse_, self.lower_impulse_,
              self.upper_impulse_);
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
    float spring_impulse_ = 0.0f;
    float motor_impulse_ = 0.0f;
    float lower_impulse_ = 0.0f;  // >= 0, towards greater values
    float upper_impulse_ = 0.0f;  // >= 0, towards smaller values
};

}  // namespace tumble
