// Statistics of a world: the work of the last step, its times, and the allocated memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble {

// Wall-clock times of the stages of a step, in their order, ms. A step of a few bodies has the time of the whole alone.
struct StageTimes {
    double pairs = 0.0;       // the broad phase, at the start of the step and after the motion
    double collide = 0.0;     // contact manifolds; waking of touched islands
    double prepare = 0.0;     // graph colouring, contact blocks, joints
    double solve = 0.0;       // sub-steps, restitution, storing of impulses
    double continuous = 0.0;  // impacts of fast bodies, final poses
    double proxies = 0.0;     // boxes of moved shapes
    double events = 0.0;      // contact and sensor events
    double sleep = 0.0;       // falling asleep
    double step = 0.0;        // the whole step
};

// Counts of the last step.
struct StepCounters {
    int bodies = 0;        // all live bodies
    int awake_bodies = 0;  // awake dynamic bodies
    int sleeping_islands = 0;
    int contacts = 0;  // pairs with at least one contact point, those of sleeping bodies too
    int contact_points = 0;
    int joints = 0;
    int colors = 0;             // of the constraint graph
    std::int64_t pairs = 0;     // pairs of solid shapes in the narrow phase
    std::int64_t collided = 0;  // those of them collided in full; the others had hardly moved and kept their manifolds
    std::int64_t gjk_iterations = 0;  // of the full collisions, as in DistanceResult::iterations
    StageTimes ms;
};

// The memory that a world has allocated, in bytes, with unused capacity.
struct WorldMemory {
    std::size_t bodies = 0;
    std::size_t shapes = 0;  // a large polygon is counted once for each shape that shares it
    std::size_t joints = 0;
    std::size_t broad_phase = 0;
    std::size_t contacts = 0;  // those of sleeping islands too
    std::size_t solver = 0;    // graph and constraint blocks of the last step
    std::size_t other = 0;     // events, islands, sweeps
    std::size_t total() const noexcept { return bodies + shapes + joints + broad_phase + contacts + solver + other; }
};

}  // namespace tumble
