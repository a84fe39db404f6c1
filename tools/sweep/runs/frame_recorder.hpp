// The pictures of runs: frames and masks as PNG, or frames as MP4.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sweep/plan/plan.hpp"
#include "tools/sweep/runs/run_video.hpp"
#include "tumble/recording.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// What draws the frames on this machine: "3.3 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)", and the
// version of ffmpeg if they become videos. The bytes of frames depend on it; empty without frames. Throws RenderError
// if there is no off-screen OpenGL, or no ffmpeg for videos.
std::string frame_software(const sweep::Written& written);

// A thread keeps one for all of its runs, with an off-screen context and fonts. To be used on that thread.
class FrameRecorder {
public:
    // Throws RenderError.
    explicit FrameRecorder(const sweep::Written& written);

    // A new run in its initial state, from which the cameras are made.
    void start(const Scene& scene, const SceneWorld& built);

    // To be called for the initial state (step 0) and after each step. Appends the pictures that are due: their suffix
    // in the tar file ("frame.000010.png", "mask.000010.png"), and their bytes. Throws RenderError and FileError.
    void record(const Scene& scene, const SceneWorld& built, std::uint64_t step,
                std::vector<std::pair<std::string, std::string>>& members);

    // To be called after the last step of a run whose pictures are kept. Appends the video, if there is one:
    // "frames.mp4". Throws as record().
    void finish(std::vector<std::pair<std::string, std::string>>& members);

private:
    const sweep::Written& written_;
    std::optional<Renderer> renderer_;
    std::optional<Labeller> labeller_;
    std::optional<RunVideo> video_;  // of this run
    Camera frame_camera_, mask_camera_;
    Overlay overlay_;
    Image image_;
};

}  // namespace tumble::tools
