// The present position and speed of the free motions of joints.
#include <cmath>
#include <variant>

#include "dynamics/rows/joint_angle.hpp"
#include "dynamics/rows/joint_bodies.hpp"
#include "world/world_impl.hpp"

namespace tumble {

namespace {

// A body of a joint in the present state. Sums are in double, as positions are.
struct End {
    const BodyFrame& frame;
    const SolverBody& body;

    double turning() const { return double{body.angular_velocity}; }
    DVec2 point(Vec2 local) const { return transform_point(frame.pose, local); }
    DVec2 velocity_of(DVec2 point) const { return DVec2(body.velocity) + cross(turning(), point - frame.center); }
};

End end_of(const BodyStore& bodies, BodyId id) {
    const BodyFrame& frame = bodies.frames[id.index];
    return {frame, bodies.solver_bodies[frame.solver_body]};
}

JointMotion motion_of_line(DVec2 from, DVec2 from_velocity, DVec2 to, DVec2 to_velocity) {
    const DVec2 line = to - from;
    const double distance = length(line);
    return {distance, distance > 0.0 ? dot(line, to_velocity - from_velocity) / distance : 0.0};
}

JointMotion measure_motion(const Simulation& simulation, JointId id);

struct Measure {
    const Simulation& simulation;
    JointId id;

    JointMotion operator()(const FilterJointDef&) const { return {}; }

    JointMotion operator()(const GearJointDef& def) const {
        const double speed = measure_motion(simulation, def.joint_a).speed +
                             double{def.ratio} * measure_motion(simulation, def.joint_b).speed;
        return {double{simulation.joints.position(id)}, speed};
    }

    JointMotion operator()(const PulleyJointDef& def) const {
        const End a = end_of(simulation.bodies, def.body_a);
        const DVec2 anchor = a.point(def.anchor_a);
        return motion_of_line(def.ground_anchor_a, {}, anchor, a.velocity_of(anchor));
    }

    JointMotion operator()(const auto& def) const {
        const End a = end_of(simulation.bodies, def.body_a), b = end_of(simulation.bodies, def.body_b);
        const DVec2 from = a.point(def.anchor_a), to = b.point(def.anchor_b);
        if constexpr (requires { def.axis_a; })
            return along(rotate(a.frame.pose.rotation, DVec2(unit(def.axis_a))), a, from, b, to);
        else if constexpr (requires { def.reference_angle; })
            return {turned(a, b, double{def.reference_angle}), b.turning() - a.turning()};
        else
            return motion_of_line(from, a.velocity_of(from), to, b.velocity_of(to));
    }

    // The displacement along an axis that is fixed in A and goes through its anchor.
    JointMotion along(DVec2 axis, const End& a, DVec2 from, const End& b, DVec2 to) const {
        return {dot(axis, to - from), dot(axis, b.velocity_of(to) - a.velocity_of(to))};
    }

    // With the whole turns that bring it nearest to the angle of the last step.
    double turned(const End& a, const End& b, double reference) const {
        const double wrapped = relative_angle(a.frame.pose.rotation, b.frame.pose.rotation) - reference;
        const double before = double{simulation.joints.position(id)};
        return wrapped + std::nearbyint((before - wrapped) / (2.0 * kPi)) * (2.0 * kPi);
    }
};

JointMotion measure_motion(const Simulation& simulation, JointId id) {
    return std::visit(Measure{simulation, id}, simulation.joints.def(id));
}

}  // namespace

JointMotion World::joint_motion(JointId id) const {
    impl_->require(id);
    return measure_motion(impl_->simulation, id);
}

}  // namespace tumble
