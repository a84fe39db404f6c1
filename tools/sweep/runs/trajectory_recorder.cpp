#include "tools/sweep/runs/trajectory_recorder.hpp"

#include <limits>

namespace tumble::tools {

namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void TrajectoryRecorder::record(const SceneWorld& built) {
    std::vector<double>& row = rows_.emplace_back();
    row.reserve(built.bodies.size() * sweep::kStateNumbers);
    for (const SceneInstance& body : built.bodies) {
        if (!built.world.is_valid(body.id)) {
            row.insert(row.end(), sweep::kStateNumbers, kAbsent);
            continue;
        }
        const BodyState state = built.world.state(body.id);
        row.insert(row.end(), {state.pose.position.x, state.pose.position.y, angle(state.pose.rotation),
                               static_cast<double>(state.velocity.x), static_cast<double>(state.velocity.y),
                               static_cast<double>(state.angular_velocity)});
    }
}

sweep::TrajectoryArray TrajectoryRecorder::array() const {
    const std::size_t columns = rows_.empty() ? 0 : rows_.back().size();  // bodies are added, and never removed
    sweep::TrajectoryArray result{rows_.size(), columns / sweep::kStateNumbers, {}};
    result.numbers.reserve(rows_.size() * columns);
    for (const std::vector<double>& row : rows_) {
        result.numbers.insert(result.numbers.end(), row.begin(), row.end());
        result.numbers.insert(result.numbers.end(), columns - row.size(), kAbsent);
    }
    return result;
}

}  // namespace tumble::tools
