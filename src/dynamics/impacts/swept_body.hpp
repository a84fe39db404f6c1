// The motion of a body during the part of a step that is still ahead of it.
//
// Times are fractions of the step, 0 at its start and 1 at its end. A body without contact or joint flies freely: it
// has an acceleration, and its mean velocity differs from the velocity that it starts with. The solver has decided the
// motion of any other body: an impact changes its velocity and its mean velocity by the same.
#pragma once

#include <cmath>
#include <cstdint>

#include "debug/check.hpp"
#include "tumble/cast.hpp"
#include "tumble/math.hpp"

namespace tumble {

// A velocity (m/s, rad/s) or an acceleration (m/s^2, rad/s^2) of a body.
struct Twist {
    DVec2 linear;  // of the centre of mass
    double angular = 0.0;

    friend constexpr bool operator==(const Twist&, const Twist&) = default;
    friend constexpr Twist operator+(const Twist& a, const Twist& b) {
        return {a.linear + b.linear, a.angular + b.angular};
    }
    friend constexpr Twist operator*(double s, const Twist& a) { return {s * a.linear, s * a.angular}; }
};

// The part of a sweep between two fractions; a body at rest if they are equal.
inline Sweep part_of(const Sweep& sweep, double from, double to) {
    TUMBLE_CHECK(!(to < from));
    const DVec2 path = sweep.end - sweep.start;
    return {sweep.local_center, sweep.start + from * path, sweep.start + to * path,
            sweep.start_angle + from * sweep.turn, (to - from) * sweep.turn};
}

struct SweptBody {
    std::uint32_t body = 0;  // index
    double time = 0.0;       // at which the sweep starts; it ends at time 1
    Sweep sweep;
    Twist velocity;      // at `time`
    Twist acceleration;  // of a free body; zero otherwise
    bool is_free = false;
    bool has_stopped = false;  // it has had as many impacts as a step allows, and rests until the step ends
    int impact_count = 0;

    // The motion from a time on, which must not be before `time`.
    Sweep sweep_from(double from) const {
        return part_of(sweep, from > time ? (from - time) / (1.0 - time) : 0.0, 1.0);
    }

    // The mean velocity of the motion ahead; zero at the end of the step. `duration` is that of the whole step, s.
    Twist mean_velocity(double duration) const {
        const double ahead = (1.0 - time) * duration;
        if (!(ahead > 0.0)) return {};
        return (1.0 / ahead) * Twist{sweep.end - sweep.start, sweep.turn};
    }

    Twist final_velocity(double duration) const { return velocity + (1.0 - time) * duration * acceleration; }

    // Moves the start of the sweep to a later time.
    void advance(double to, double duration);

    // Changes the velocity at `time`, and the motion ahead.
    void push(const Twist& change, double duration) {
        const double ahead = (1.0 - time) * duration;
        velocity = velocity + change;
        sweep.end += ahead * change.linear;
        sweep.turn += ahead * change.angular;
    }

    // Changes the displacement ahead as this velocity would, but not the velocity.
    void hold(const Twist& change, double duration) {
        const double ahead = (1.0 - time) * duration;
        sweep.end += ahead * change.linear;
        sweep.turn += ahead * change.angular;
    }

    // The body stays where it is until the step ends.
    void stop() {
        sweep.end = sweep.start;
        sweep.turn = 0.0;
        has_stopped = true;
    }
};

// A free body moves along a chord of its parabola. The speed along the acceleration a follows from v^2 - 2 a x, so that
// a body that bounces keeps its energy wherever it meets the surface.
inline DVec2 velocity_after(DVec2 velocity, DVec2 acceleration, double time, DVec2 displacement) {
    const double size = length(acceleration);
    if (!(size > 0.0)) return velocity;
    const DVec2 along = (1.0 / size) * acceleration;
    const double start = dot(velocity, along), later = start + size * time;
    const double square = start * start + 2.0 * size * dot(displacement, along);
    const double speed = std::copysign(std::sqrt(square > 0.0 ? square : 0.0), later);
    return velocity + (speed - start) * along;
}

inline void SweptBody::advance(double to, double duration) {
    TUMBLE_CHECK(!(to > 1.0));
    if (!(to > time)) return;
    const double passed = (to - time) * duration, ahead = (1.0 - to) * duration;
    const Sweep rest = sweep_from(to);
    velocity.linear = velocity_after(velocity.linear, acceleration.linear, passed, rest.start - sweep.start);
    velocity.angular += passed * acceleration.angular;
    sweep = rest;
    time = to;
    if (!is_free || has_stopped) return;
    sweep.end = sweep.start + ahead * (velocity.linear + 0.5 * ahead * acceleration.linear);
    sweep.turn = ahead * (velocity.angular + 0.5 * ahead * acceleration.angular);
}

}  // namespace tumble
