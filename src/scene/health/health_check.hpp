// A check of a run: sees each state, and gives its findings at the end.
#pragma once

#include <memory>
#include <vector>

#include "scene/health/culprits.hpp"
#include "scene/health/health_view.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::scene {

class HealthCheck {
public:
    virtual ~HealthCheck() = default;

    // Called for the initial state and after each step.
    virtual void observe(const HealthView& view) = 0;

    // Appends the findings up to the state of the view, which is the last that was observed.
    virtual void report(const HealthView& view, std::vector<HealthFinding>& findings) const = 0;
};

// In the order of kHealthChecks. make_overlap_check() is in overlap_check.cpp, and so on.
std::unique_ptr<HealthCheck> make_overlap_check();
std::unique_ptr<HealthCheck> make_tunnelling_check();
std::unique_ptr<HealthCheck> make_lost_check();
std::unique_ptr<HealthCheck> make_jitter_check();
std::unique_ptr<HealthCheck> make_joint_check();
std::unique_ptr<HealthCheck> make_mass_check();
std::unique_ptr<HealthCheck> make_sleep_check();
std::unique_ptr<HealthCheck> make_speed_check();
std::unique_ptr<HealthCheck> make_energy_check();
std::unique_ptr<HealthCheck> make_size_check();
std::unique_ptr<HealthCheck> make_spring_check();
std::unique_ptr<HealthCheck> make_motor_check();

}  // namespace tumble::scene
