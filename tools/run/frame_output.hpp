// Draws the frames of a run and passes them to the encoder threads, to the video and to the raw video.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "tools/output/plot_strip.hpp"
#include "tools/run/frame_drawers.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tools/run/frame_views.hpp"
#include "tools/run/raw_video.hpp"
#include "tools/run/run_options.hpp"
#include "tools/run/run_report.hpp"
#include "tumble/recording.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

class FrameOutput {
public:
    // The world must be in its initial state: the camera is computed from it.
    FrameOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options, const FrameSchedule& schedule);

    // Draws the frames that show the world's current step, if there are any. Must be called after each step, because
    // the camera follows the bodies.
    void draw_due(const SceneWorld& world);

    // Waits until all frames are written, and ends the videos. Throws the first FileError or RenderError.
    std::vector<WrittenFiles> finish();

    // Waits until the PNG files of all frames so far are written; more may follow.
    WrittenFiles finish_frames();

    // What later frames depend on, and what the summary says of earlier ones.
    struct State {
        Camera camera;
        std::vector<Trail> trails;
        std::vector<FrameView> views;
    };
    State state() const { return {camera_, marking_.trails, views_}; }

    // Continues after the frames that an earlier run has drawn and written.
    void continue_from(State state, std::uint64_t frames, std::uint64_t bytes);

    const std::vector<FrameView>& views() const noexcept { return views_; }
    std::uint64_t drawn() const noexcept { return next_frame_; }
    double render_seconds() const noexcept { return drawers_.seconds() + other_seconds_; }
    double encode_seconds() const noexcept { return encode_seconds_; }

private:
    void draw(const SceneWorld& world);
    void write_frame(Image image);
    Image image_to_draw();

    const Scene& scene_;
    const RunOptions& options_;
    FrameSchedule schedule_;
    Camera camera_;
    std::optional<PlotStrip> plots_;
    std::optional<VideoWriter> video_;
    std::optional<RawVideo> raw_video_;
    FrameWriter writer_;
    FrameDrawers drawers_;
    Marking marking_;  // the trails
    std::vector<FrameView> views_;
    std::vector<Image> spare_;  // without PNG files, those to draw into
    std::uint64_t next_frame_ = 0, next_written_ = 0;
    std::uint64_t earlier_frames_ = 0, earlier_bytes_ = 0;
    double encode_seconds_ = 0.0;
    double other_seconds_ = 0.0;  // of cameras, trails and videos
};

}  // namespace tumble::tools
