// The state of a run as bytes: what SceneRun has beside its scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tumble/scene_world.hpp"

namespace tumble::scene {

// How far an event of the timeline is.
struct SavedEvent {
    std::uint64_t count = 0;    // how often it has occurred
    std::uint64_t spawned = 0;  // how many bodies it has spawned
    std::uint64_t held = 0;     // 1 + the step whose state its condition first held in; 0: none yet
};

struct SavedRun {
    std::uint64_t scene_hash = 0;       // without the duration
    std::vector<SceneInstance> bodies;  // SceneWorld::bodies
    std::vector<SavedEvent> events;     // [Scene::timeline.size()]
    double work = 0.0;                  // SceneWorld::work
    std::vector<std::byte> world{};     // World::save()
};

// Little-endian numbers, and a hash of all bytes at the end.
std::vector<std::byte> to_bytes(const SavedRun& run);

// Throws SnapshotError for bytes that to_bytes() has not made.
SavedRun read_saved_run(std::span<const std::byte> bytes);

}  // namespace tumble::scene
