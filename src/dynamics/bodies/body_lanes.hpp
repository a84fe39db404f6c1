// Eight solver bodies as lanes: every member of SolverBody is an array of them.
#pragma once

#include "dynamics/bodies/solver_body.hpp"
#include "simd/transpose.hpp"

namespace tumble {

// Eight rotations.
struct LaneTurn {
    Lanes c, s;
};

struct BodyLanes {
    Lanes velocity_x, velocity_y, angular_velocity, flags;
    Lanes delta_x, delta_y, delta_c, delta_s;
};

// rows[kLaneCount]: the first floats of the bodies.
TUMBLE_LANE_FUNCTION BodyLanes gather_bodies(const float* const rows[kLaneCount]) {
    Lanes f[8];
    gather_rows(rows, f);
    return {f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]};
}

}  // namespace tumble
