// What a world has to say of itself: how much there was to do in a step, how long it took, and the memory it holds.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble {

// Wall clock of the stages of a step, in their order, ms.
struct StageTimes {
    double pairs = 0.0;       // the broad phase: before the step, and after its motion
    double collide = 0.0;     // manifolds, and the waking of what is touched
    double prepare = 0.0;     // colouring, constraint blocks, joints
    double solve = 0.0;       // the sub-steps, restitution, impulses kept
    double continuous = 0.0;  // impacts of fast bodies, and the final poses
    double proxies = 0.0;     // boxes of what has moved
    double events = 0.0;      // what begins and ends, sensors
    double sleep = 0.0;       // falling asleep
    double step = 0.0;        // all of it
};

// What the last step did.
struct StepCounters {
    int bodies = 0;        // all live bodies
    int awake_bodies = 0;  // of those that can sleep: dynamic ones
    int sleeping_islands = 0;
    int contacts = 0;  // pairs with at least one manifold point, those of sleeping bodies too
    int contact_points = 0;
    int joints = 0;
    int colors = 0;                   // of the constraint graph
    std::int64_t pairs = 0;           // of shapes that the narrow phase was asked about, sensors apart...
    std::int64_t collided = 0;        // ...and of these, in full: the rest had barely moved and kept their manifolds
    std::int64_t gjk_iterations = 0;  // of all full ones, as DistanceResult::iterations counts them
    StageTimes ms;
};

// Memory that a world has allocated, by what it is for, bytes. What is free for later growth counts.
struct WorldMemory {
    std::size_t bodies = 0;
    std::size_t shapes = 0;  // large polygons once for each shape that shares them
    std::size_t joints = 0;
    std::size_t broad_phase = 0;
    std::size_t contacts = 0;  // those of sleeping islands too
    std::size_t solver = 0;    // graph and constraint blocks of the last step
    std::size_t other = 0;     // events, islands, sweeps
    std::size_t total() const noexcept { return bodies + shapes + joints + broad_phase + contacts + solver + other; }
};

}  // namespace tumble
