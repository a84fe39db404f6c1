// Revolute joint (hinge): constrains B's anchor to A's. A point block (joint_block.hpp; m, N s on B along the world
// axes), and an angular row that a drive may act on: spring, motor and limits of the joint angle (rad, N m s,
// counter-clockwise positive for B against A).
#pragma once

#include <span>

#include "dynamics/rows/equality_row.hpp"
#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_block.hpp"
#include "dynamics/rows/joint_drive.hpp"

namespace tumble {

class RevoluteJoint {
public:
    RevoluteJoint() = default;
    explicit RevoluteJoint(const RevoluteJointDef& def)
        : body_a_(def.body_a.index),
          body_b_(def.body_b.index),
          anchor_a_(def.anchor_a),
          anchor_b_(def.anchor_b),
          reference_angle_(def.reference_angle),
          drive_(def.spring, drive_motor(def.motor), def.limits) {}

    void prepare(const BodyStore& bodies);
    // Whether it is the only joint with rows of its dynamic bodies in this step.
    void set_lone(bool is_lone) { is_lone_ = is_lone; }
    void update_rows(std::span<const SolverBody> bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    std::uint32_t body_a() const { return body_a_; }  // indices
    std::uint32_t body_b() const { return body_b_; }
    std::uint32_t drive_parts() const { return drive_.parts(); }
    // False if a body is locked along an axis or neither can turn: lanes do not solve such a joint.
    bool fits_lanes(const BodyStore& bodies) const;

    // Calls visit(EqualityRow) for each equality constraint, at the present deltas of the bodies.
    template <class Visitor>
    void visit_equalities(std::span<const SolverBody> bodies, Visitor&& visit) {
        visit_point(bodies_, bodies, impulse_, visit);
    }
    JointReaction reaction(float inv_h) const { return {inv_h * impulse_, inv_h * drive_.impulse()}; }
    float position() const { return angle_.at_start(); }
    void take_over(const RevoluteJoint& old);
    void forget_impulses() { impulse_ = {}, drive_.forget_impulses(); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.body_a_, self.body_b_, self.anchor_a_, self.anchor_b_, self.reference_angle_, self.bodies_,
              self.block_, self.angle_, self.range_, self.drive_, self.impulse_, self.is_lone_);
    }

private:
    friend class RevoluteLanes;  // copies joints to lanes and back

    void solve_drive(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);

    // The members of the definition that a step reads. The whole definition would make this array larger, and scenes
    // have thousands of hinges.
    std::uint32_t body_a_ = 0, body_b_ = 0;
    Vec2 anchor_a_, anchor_b_;
    float reference_angle_ = 0.0f;
    JointBodies bodies_;
    PointBlock block_;  // of the last update_rows()
    JointAngle angle_;
    PositionRange range_;  // of the angle at the last update_rows(), with a spring or limits
    JointDrive drive_;
    Vec2 impulse_;          // on B, N s
    bool is_lone_ = false;  // in this step
};

}  // namespace tumble
