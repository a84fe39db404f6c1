// The largest overlap, joint error and speed of a run, with their moments.
#pragma once

#include <vector>

#include "scene/health/health_view.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::scene {

class Extremes {
public:
    void observe(const HealthView& view);

    // Those that are greater than 0.
    std::vector<HealthExtreme> list() const;

private:
    void observe_joints(const HealthView& view);

    HealthExtreme overlap_{.quantity = "deepest overlap", .unit = "m"};
    HealthExtreme joint_error_{.quantity = "largest joint error", .unit = "m"};
    HealthExtreme speed_{.quantity = "fastest body", .unit = "m/s"};
};

}  // namespace tumble::scene
