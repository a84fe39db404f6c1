// Two moving cores: their poses at a fraction of their sweeps, relative to each other and in double.
#pragma once

#include "narrow/cores/core_pair.hpp"
#include "tumble/cast.hpp"

namespace tumble {

struct MovingCores {
    CorePair pair;   // rotations in double
    DVec2 center_a;  // the centres of mass in world axes, each relative to its body's position
    DVec2 center_b;
    DVec2 separation;  // from A's centre of mass to B's
};

// The constants of a motion.
class Motion {
public:
    // The reach, radii and target together, is one of the sizes that the error bound is relative to.
    Motion(const Shape& a, const Sweep& sweep_a, const Shape& b, const Sweep& sweep_b, double reach);

    bool is_valid() const { return is_valid_; }
    MovingCores at(double fraction) const;

    // Moves cores from at() to another fraction, number by number: a copy of a structure that was just stored in parts
    // would stall.
    void move(MovingCores& cores, double fraction) const;

    DVec2 separation() const { return separation_; }  // from A's centre of mass to B's at the start
    DVec2 velocity() const { return velocity_; }      // of B's centre relative to A's, m a whole motion
    double turn_a() const { return a_.turns; }
    double turn_b() const { return b_.turns; }
    double extent_a() const { return a_.extent; }  // of the cores from their centres of mass, at least
    double extent_b() const { return b_.extent; }

    // E: the error bound of a signed core distance at any fraction, with the roundings of angles and centres.
    double error() const { return error_; }

private:
    struct Body {
        Core core;
        DVec2 local_center;
        double extent;
        double turns;  // radians
        SinCos start;

        void turn(double fraction, Core& core_there, DVec2& center) const;
    };

    static Body make_body(const Shape& shape, const Sweep& sweep);

    Body a_;
    Body b_;
    DVec2 separation_;
    DVec2 velocity_;
    double scale_;
    double error_;
    bool is_valid_;
};

}  // namespace tumble
