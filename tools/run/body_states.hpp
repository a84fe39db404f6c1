// The states of all bodies, step by step, from a trajectory file or from a scene that runs: what `diff` compares.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene_file.hpp"

namespace tumble::tools {

inline constexpr std::array<std::string_view, 6> kComponents{"x", "y", "angle", "vx", "vy", "omega"};

// The first two, the position (m), are double in the engine. The angle (rad) is written as double, but comes from a
// float cosine and sine; the velocities (m/s, rad/s) are float.
inline constexpr std::size_t kPreciseComponents = 2;
inline constexpr std::size_t kDoubleComponents = 3;

struct NamedState {
    std::string body;
    std::array<double, kComponents.size()> values{};  // as kComponents

    friend bool operator==(const NamedState&, const NamedState&) = default;
};

struct StepStates {
    std::uint64_t step = 0;
    double time = 0.0;  // s
    std::vector<NamedState> bodies;
};

class StateSource {
public:
    virtual ~StateSource() = default;

    // The next step; false after the last. Throws InputError for lines that are not a trajectory's, SimulationDiverged.
    virtual bool next(StepStates& states) = 0;

    // The contacts of a body in the step that was read last, a line each.
    virtual std::vector<std::string> contacts_of(const std::string& body) = 0;
};

// A scene file (.json), a trajectory (.csv), or the folder of a run that holds trajectory.csv; a run's contacts are
// those of contacts.csv beside the trajectory. Throws FileError, InputError or SceneError. `changes` are those of a
// scene.
std::unique_ptr<StateSource> open_states(const std::filesystem::path& path, const LoadOptions& changes = {});

// Whether open_states() would run it.
bool is_scene_file(const std::filesystem::path& path);

}  // namespace tumble::tools
