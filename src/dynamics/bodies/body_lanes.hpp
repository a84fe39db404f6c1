// Eight solver bodies as lanes: every member of SolverBody is an array of them.
#pragma once

#include <cstdint>
#include <span>

#include "debug/check.hpp"
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

// A solver body by its position in floats: kernels find its address without a shift, and take 2 to 5 % less time.
struct BodyRow {
    std::uint32_t position = 0;

    static constexpr std::uint32_t kFloats = sizeof(SolverBody) / sizeof(float);
    static constexpr BodyRow of(std::uint32_t solver_body) { return {kFloats * solver_body}; }
    constexpr std::uint32_t index() const { return position / kFloats; }
};

inline constexpr std::uint8_t kAllLanes = 0xff;
static_assert(kLaneCount == 8);

// The bodies of eight rows: the bodies A, or the bodies B, of a block of contacts or joints.
TUMBLE_LANE_FUNCTION BodyLanes gather(std::span<const SolverBody> bodies, const BodyRow body[kLaneCount]) {
    const float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) {
        TUMBLE_CHECK(body[lane].index() < bodies.size());
        rows[lane] = reinterpret_cast<const float*>(bodies.data()) + body[lane].position;
    }
    return gather_bodies(rows);
}

// scatter_velocities() for a block that can move some of the bodies only, which is rare.
[[gnu::noinline]] inline void scatter_some(const Lanes fields[4], std::span<SolverBody> bodies,
                                           const BodyRow body[kLaneCount], std::uint8_t moved) {
    alignas(16) float unmoved[4];
    float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane)
        rows[lane] = moved >> lane & 1 ? &bodies[body[lane].index()].velocity.x : unmoved;
    scatter_rows(fields[0], fields[1], fields[2], fields[3], rows);
}

// Writes the velocities of the bodies that the block can move. The others may be in several blocks of a colour, which
// threads solve at the same time.
TUMBLE_LANE_FUNCTION void scatter_velocities(const BodyLanes& lanes, std::span<SolverBody> bodies,
                                             const BodyRow body[kLaneCount], std::uint8_t moved) {
    if (moved == 0) return;
    if (moved != kAllLanes) {
        // A copy, so that the lanes stay in registers: passing their address makes the solver 10 % slower.
        const Lanes fields[4] = {lanes.velocity_x, lanes.velocity_y, lanes.angular_velocity, lanes.flags};
        return scatter_some(fields, bodies, body, moved);
    }
    float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) {
        TUMBLE_CHECK(body[lane].index() < bodies.size());
        rows[lane] = reinterpret_cast<float*>(bodies.data()) + body[lane].position;
    }
    scatter_rows(lanes.velocity_x, lanes.velocity_y, lanes.angular_velocity, lanes.flags, rows);
}

}  // namespace tumble
