// Replays: a run as one HTML page, which plays it in any browser without a network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// Limits of the memory that a replay takes. A browser unpacks 12 bytes for each pose and 16 for each contact point. The
// recorder packs them into about 4 bytes each, at most 15 and 20; page() takes three times that for a moment. A contact
// that begins counts as ten points more.
inline constexpr std::size_t kMostReplayPoses = 30'000'000;
inline constexpr std::size_t kMostReplayContactPoints = 60'000'000;

// A claim of the scene as the page shows it: a mark at the step that decided it, green or red, and the regions and
// bodies of the marking. The page has no caption.
struct ReplayClaim {
    ExpectationResult result;
    Marking marking{};
};

struct ReplaySettings {
    double aspect_ratio = 16.0 / 9.0;  // width of the frames over their height
    bool contacts = true;              // record the contact points, which doubles the size of the page
    std::size_t most_poses = kMostReplayPoses;
    std::size_t most_contact_points = kMostReplayContactPoints;
};

// Records the states of a run. Positions are kept to half a quantum: 0.5 mm, or less in a world whose
// WorldDef::scale is below 1; angles to 1/8192 turn. The same run gives the same page.
class ReplayRecorder {
public:
    // Copies what it needs of the scene.
    ReplayRecorder(const Scene& scene, const ReplaySettings& settings);
    ~ReplayRecorder();
    ReplayRecorder(ReplayRecorder&&) noexcept;
    ReplayRecorder& operator=(ReplayRecorder&&) noexcept;

    // To be called for the initial state and after each step, with the camera of its frame: see move_camera(). From the
    // step on with which the replay would have more poses or contact points than the settings allow, nothing is
    // recorded.
    void record(const SceneWorld& built, const Camera& camera);

    // True if every state so far is recorded.
    bool is_whole() const noexcept;

    // The page of the states so far, of which there must be one. `complete` is false for a run that ended early, which
    // the page says.
    std::string page(std::span<const ReplayClaim> claims, bool complete) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
