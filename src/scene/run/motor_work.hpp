// The work of the motors of joints during a step.
//
// A world tells the effort (force or torque) of a joint in the last sub-step, not that in each. The work of a motor in
// a step is therefore known within bounds: it is that effort times the displacement if the effort is steady, and at
// most the largest effort times the displacement, as when a motor starts or hits something within the step. Of this
// range, the work is what explains by how much the energy grew.
#pragma once

#include <vector>

#include "tumble/scene_world.hpp"

namespace tumble::scene {

class MotorWork {
public:
    explicit MotorWork(const SceneWorld& built);

    // To be called before a step, after the events that are due.
    void start_step(const World& world);

    // To be called after it: the work of all motors in J. `other_work` is the other work that was put in.
    double end_step(const World& world, double other_work) const;

private:
    // The relative motion of the two bodies of a joint.
    struct Motion {
        Rotation rotation;     // from that of A to that of B
        double turning = 0.0;  // rad/s
        DVec2 separation;      // from A's anchor to B's, world axes, m; 0 for a motor that only turns
        DVec2 velocity;        // of B's anchor relative to A's, m/s; 0 for such a motor
    };
    struct Driven {
        JointId joint;
        bool exists = false;
        bool was_asleep = false;  // when `start` was measured; a sleeping joint still has this motion
        Motion start{};
    };
    struct Bounds {
        double steady = 0.0;  // J
        double most = 0.0;    // J
    };

    static Motion motion_of(const World& world, JointId joint);
    static void start_step(const World& world, Driven& driven);
    static Bounds bounds_of(const World& world, const Driven& driven);

    std::vector<Driven> driven_;
    double energy_ = 0.0;  // J, at the start of the step
};

}  // namespace tumble::scene
