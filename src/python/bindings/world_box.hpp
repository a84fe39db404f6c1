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
#include <stdexcept>
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

// A call to a world or an environment that another thread steps.
class InUse : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

class WorldBox {
public:
    explicit WorldBox(World&& world) : own_(std::move(world)) {}
    explicit WorldBox(WatchedRun&& run) : run_(std::move(run)) {}

    // Throw InUse while another thread steps the world. change() is for what may alter poses or velocities.
    const World& world() const;
    World& change();
    WatchedRun& run();  // throws std::runtime_error if the world has no scene

    // Advances by a number of steps, without the GIL. A run that its timeline has stopped stays as it
    // is. Ends early, with the exception, if Python has a signal. Arrays that Python holds show the state afterwards,
    // also after an exception.
    void step(std::int64_t count);

    // The threads that make a step: World::set_threads().
    int threads() const { return world().def().threads.count; }
    void set_threads(int count);

    // Advances all boxes on the threads, each by a number of steps on one of them. All make their steps; then the
    // exception of the first that failed is thrown. Throws std::invalid_argument for a box that is there twice.
    static void step_all(const std::vector<WorldBox*>& boxes, std::int64_t count, int threads);

    // The present array of a quantity: read-only, [bodies] or [bodies, 2].
    py::array array(Quantity quantity);

    // The ids of the bodies as numbers, [bodies].
    py::array_t<std::uint64_t> ids();

private:
    // Takes the flag of a box for the duration of its steps.
    class Stepping;

    void require_idle() const;
    void step_once();
    void advance(std::int64_t count);
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
