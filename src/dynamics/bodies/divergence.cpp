#include "dynamics/bodies/divergence.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"

namespace tumble {

namespace {

std::uint32_t find_moved_static(const BodyStore& bodies) {
    if (!has_moved_static(bodies)) return kNoBody;
    std::uint32_t first = kNoBody;
    for (const BodyId id : bodies.ids.live()) {
        if (bodies.frames[id.index].solver_body != kStaticSolverBody || bodies.is_asleep(id.index)) continue;
        if (!bodies.records[id.index].joints.empty()) return id.index;
        first = std::min(first, id.index);
    }
    return first;
}

}  // namespace

std::uint32_t find_diverged(const BodyStore& bodies) {
    std::uint32_t first = kNoBody;
    for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        const SolverBody& body = bodies.solver_bodies[i];
        TUMBLE_CHECK(bodies.moving[i].body < bodies.frames.size());
        const BodyFrame& frame = bodies.frames[bodies.moving[i].body];
        if (!is_finite(body, frame)) first = std::min(first, bodies.moving[i].body);
    }
    return first != kNoBody ? first : find_moved_static(bodies);
}

bool has_finite_pose(const BodyStore& bodies, std::uint32_t body) {
    const Pose& pose = bodies.frames[body].pose;
    return is_finite(pose.position) && is_finite(Vec2{pose.rotation.c, pose.rotation.s});
}

}  // namespace tumble
