// Collects the states of a run as an array.
#pragma once

#include <vector>

#include "sweep/store/trajectory_array.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

// The bodies are in the order of creation. A body has NaN in the states before it exists and after it is destroyed.
class TrajectoryRecorder {
public:
    void record(const SceneWorld& built);
    sweep::TrajectoryArray array() const;

private:
    std::vector<std::vector<double>> rows_;
};

}  // namespace tumble::tools
