// The states of all bodies, step by step, from a trajectory file or from a scene that is simulated.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

inline constexpr std::array<std::string_view, 6> kComponents{"x", "y", "angle", "vx", "vy", "omega"};

// The position (m), the first two, is double in the engine. The angle (rad) is written as double, computed from a float
// cosine and sine. The velocities (m/s, rad/s) are float.
inline constexpr std::size_t kPreciseComponents = 2;
inline constexpr std::size_t kDoubleComponents = 3;

struct NamedState {
    std::string body;
    std::array<double, kComponents.size()> values{};  // in the order of kComponents
    bool has_name = true;  // false: `body` is body[i], by the index of the body, which other runs may count otherwise
    std::uint64_t shapes = 0;  // a hash of its shapes; 0: unknown, as in a trajectory
};

struct StepStates {
    std::uint64_t step = 0;
    double time = 0.0;  // s
    std::vector<NamedState> bodies;
};

class StateSource {
public:
    virtual ~StateSource() = default;

    // Reads the next step; false after the last. Throws InputError for a line that is not valid, SimulationDiverged.
    virtual bool next(StepStates& states) = 0;

    // The contacts of a body in the step that was read last, as one line of text each.
    virtual std::vector<std::string> contacts_of(const std::string& body) = 0;

    // The scene, and its world in the state that was read last; null for a table.
    virtual const Scene* scene() const { return nullptr; }
    virtual const SceneWorld* built() const { return nullptr; }

    // Kinetic and potential energy in that state, J; NaN for a table, which has no masses.
    virtual double energy() const { return std::numeric_limits<double>::quiet_NaN(); }
};

// Opens a scene file, a trajectory (.csv), or the folder of a run with trajectory.csv. The contacts of a trajectory are
// read from contacts.csv in the same folder, if it exists. `changes` apply to a scene only. Throws FileError,
// InputError or SceneError.
std::unique_ptr<StateSource> open_states(const std::filesystem::path& path, const LoadOptions& changes = {});

// Whether open_states() simulates this path: it is neither a folder nor a table (.csv, or from standard input).
bool is_scene_file(const std::filesystem::path& path);

}  // namespace tumble::tools
