// A world as Python holds it: alone, or inside the run of a scene, with the arrays that show its state.
//
// The arrays are numpy arrays that own their memory. The box keeps one for each quantity, and a step rewrites those
// that someone else refers to as well. When bodies were created or destroyed, the box makes new arrays, and older ones
// keep their contents.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/world.hpp"

namespace tumble::python {

namespace py = pybind11;

enum class Quantity : std::uint8_t { position, angle, velocity, angular_velocity };
inline constexpr std::size_t kQuantities = 4;

// The run of a scene, and the watch on its claims.
struct WatchedRun {
    Scene scene;
    SceneRun run;
    ExpectationWatch watch;
    std::map<double, Camera> cameras{};  // of each aspect ratio, fitted at the first frame
};

class WorldBox {
public:
    explicit WorldBox(World&& world) : own_(std::move(world)) {}
    explicit WorldBox(WatchedRun&& run) : run_(std::move(run)) {}

    // Throw std::runtime_error while another thread steps the world. change() is for what may alter poses or
    // velocities.
    const World& world() const;
    World& change();
    WatchedRun& run();  // also if the world has no scene

    // Advances by a number of steps, without the GIL. A run that its timeline has stopped stays as it
    // is. Ends early, with the exception, if Python has a signal.
    void step(std::int64_t count);

    // The present array of a quantity: read-only, [bodies] or [bodies, 2].
    py::array array(Quantity quantity);

    // The ids of the bodies as numbers, [bodies].
    py::array_t<std::uint64_t> ids();

private:
    void require_idle() const;
    void refresh_held();
    void fill(Quantity quantity);
    py::array& slot(Quantity quantity) { return arrays_[static_cast<std::size_t>(quantity)]; }

    std::optional<World> own_;
    std::optional<WatchedRun> run_;
    std::atomic<bool> is_stepping_ = false;
    std::vector<BodyId> listed_;  // the bodies of arrays_
    std::array<py::array, kQuantities> arrays_;
    std::array<bool, kQuantities> is_current_{};  // not changed since it was filled
};

// Marks an array as read-only.
py::array read_only(py::array array);

}  // namespace tumble::python
