// Replays: a run as one HTML page, which plays it in any browser without a network.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tumble/math.hpp"
#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// A browser unpacks 16 bytes for each pose. A longer replay would need gigabytes.
inline constexpr std::size_t kMostReplayPoses = 30'000'000;

// A claim of the scene as the page shows it: a mark at its step, green or red.
struct ReplayClaim {
    std::string claim;
    std::string finding;
    bool passed = false;
    std::uint64_t step = 0;  // that decided it
    std::vector<std::array<DVec2, 4>> regions{};
    std::vector<BodyId> bodies{};
};

struct ReplaySettings {
    Camera camera;         // of the first view
    bool contacts = true;  // record the contact points, which doubles the size of the page
};

// Records the states of a run. Positions are kept to half a quantum: 0.5 mm, or less in a world whose
// WorldDef::scale is below 1; angles to 1/8192 turn. The same run gives the same page.
class ReplayRecorder {
public:
    ReplayRecorder(const Scene& scene, const ReplaySettings& settings);
    ~ReplayRecorder();
    ReplayRecorder(ReplayRecorder&&) noexcept;
    ReplayRecorder& operator=(ReplayRecorder&&) noexcept;

    // To be called for the initial state and after each step. From the step on with which the replay would have more
    // than kMostReplayPoses poses, nothing is recorded.
    void record(const SceneWorld& built);

    // True if every state so far is recorded.
    bool is_whole() const noexcept;

    // The page of the states so far. `complete` is false for a run that ended early, which the page says.
    std::string page(std::span<const ReplayClaim> claims, bool complete) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
