// Draws one frame of a scene by simulating it up to that step. Runs repeat bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "tools/run/run_options.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// Computes what to mark in the world at the step of the frame.
using Marker = std::function<Marking(const SceneWorld&)>;

struct SceneShot {
    SceneRun run;
    Camera camera;  // of the frame
};

// How the frame is drawn.
struct ShotSettings {
    FrameSize size{};
    Overlay overlay{};
    RenderBackend renderer = RenderBackend::automatic;
};

// Frames of a scene at steps that follow each other.
class SceneFrames {
public:
    // The scene must live longer. Throws RenderError.
    SceneFrames(const Scene& scene, const ShotSettings& settings);

    // Simulates up to that step, or until the scene stops, and draws it. The frame is valid until the next call.
    // Throws SimulationDiverged or RenderError.
    const Image& at(std::uint64_t step);

private:
    const Scene& scene_;
    ShotSettings settings_;
    SceneRun run_;
    Camera camera_;
    Renderer renderer_;
    Marking marking_;  // the trails
    Image image_;
};

// Simulates `step` steps, or those until the scene stops, and draws the frame into `image`. Shows no progress, so that
// threads can draw. The camera is widened to show all marks. Throws SimulationDiverged or RenderError.
SceneShot paint_scene_at(const Scene& scene, std::uint64_t step, const ShotSettings& settings, const Marker& mark,
                         Image& image);

// Simulates `step` steps, draws the frame and returns the run. The camera is widened to show all marks. Throws
// SimulationDiverged, RenderError or FileError.
SceneShot draw_scene_at(const Scene& scene, std::uint64_t step, const ShotSettings& settings,
                        const std::filesystem::path& file, const Marker& mark = {});

}  // namespace tumble::tools
