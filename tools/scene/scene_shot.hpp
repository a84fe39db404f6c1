// One frame of a scene's run, drawn by running it again to that step: runs repeat bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "tools/run/run_options.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// What to point at in a world that has come to the step.
using Marker = std::function<Marking(const SceneWorld&)>;

// Runs the scene for so many steps, draws what it shows then, and returns the run. The camera is widened to what is
// marked. Throws what went wrong.
SceneRun draw_scene_at(const Scene& scene, std::uint64_t step, FrameSize size, const std::filesystem::path& file,
                       const Overlay& overlay, const Marker& mark = {});

}  // namespace tumble::tools
