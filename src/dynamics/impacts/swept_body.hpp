// The motion of a body during the part of a step that is still ahead of it.
//
// Times are fractions of the step, 0 at its start and 1 at its end. A body without contact or joint flies freely along
// a parabola; sweeps are the chords of it. The solver has decided the motion of any other body: an impact changes its
// velocity and its mean velocity by the same.
#pragma once

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
    double first_angle = 0.0;  // when the step began, rad
    Twist velocity;            // at `time`
    Twist acceleration;        // of any other body the part of its free acceleration that it has had
    bool is_free = false;
    bool is_off_course = false;  // contacts with points may not keep it apart from all that it meets
    bool has_stopped = false;    // its impacts weigh as much as a step allows: it rests until the step ends
    int impact_count = 0;
    int impact_weight = 0;  // of these impacts: at kMaxImpactsPerBody the body stops
    int last_impact = -1;   // index among all impacts of the step; -1 for none

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

    // From the start of the step until `time`, rad.
    double turned() const { return sweep.start_angle - first_angle; }

    // Moves the start of the sweep to a later time. A free body leaves the chord for its parabola.
    void advance(double to, double duration);

    // How far the parabola of a free body is from its chord at a time, m.
    DVec2 bulge(double at, double duration) const {
        if (!is_free || has_stopped) return {};
        return (-0.5 * (at - time) * (1.0 - at) * duration * duration) * acceleration.linear;
    }

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

private:
    // Along the parabola for a time; from then on a time is ahead, s.
    void fly(double passed, double ahead);
};

inline void SweptBody::advance(double to, double duration) {
    TUMBLE_CHECK(!(to > 1.0));
    if (!(to > time)) return;
    const double passed = (to - time) * duration;
    if (is_free && !has_stopped)
        fly(passed, (1.0 - to) * duration);
    else
        sweep = sweep_from(to);
    velocity = velocity + passed * acceleration;
    time = to;
}

inline void SweptBody::fly(double passed, double ahead) {
    const Twist path = passed * (velocity + 0.5 * passed * acceleration);
    sweep.start += path.linear;
    sweep.start_angle += path.angular;
    const Twist later = velocity + passed * acceleration;
    const Twist rest = ahead * (later + 0.5 * ahead * acceleration);
    sweep.end = sweep.start + rest.linear;
    sweep.turn = rest.angular;
}

}  // namespace tumble
