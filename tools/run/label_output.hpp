// Labels of the frames of a run: masks, the order of depth, boxes. No frame needs to be drawn for them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/labels/coco_file.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tools/run/frame_views.hpp"
#include "tools/run/run_report.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

class LabelOutput {
public:
    // The world must be in its initial state: the camera is computed from it. The scene and the options must outlive
    // the object. Throws FileError, as all functions do.
    LabelOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options, const FrameSchedule& schedule);

    // Labels the frames that show the world's current step, if there are any. Must be called after each step, because
    // the camera follows the bodies.
    void label_due(const SceneWorld& world);

    // Completes the files.
    std::vector<WrittenFiles> finish(const SceneWorld& world);

    const std::vector<FrameView>& views() const noexcept { return views_; }
    double seconds() const noexcept { return seconds_; }  // wall clock, spent here

private:
    void write_frame(const SceneWorld& world, const Camera& camera, const FrameLabels& labels);
    void write_bodies(const SceneWorld& world);

    const Scene& scene_;
    const RunOptions& options_;
    FrameSchedule schedule_;
    Camera camera_;
    Labeller labeller_;
    OutputFile file_;
    std::optional<CocoFile> boxes_;
    JsonWriter json_{JsonWriter::Layout::compact};
    std::vector<FrameView> views_;
    std::uint64_t next_frame_ = 0;
    std::uint64_t mask_bytes_ = 0;
    double seconds_ = 0.0;
};

}  // namespace tumble::tools
