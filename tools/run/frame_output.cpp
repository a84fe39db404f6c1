#include "tools/run/frame_output.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "tools/measure/stopwatch.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/video_output.hpp"

namespace tumble::tools {

namespace {

// Below the time: how slow a frame is.
std::vector<std::string> caption_at(double speed) {
    if (speed == 1.0) return {};
    std::string text;
    append_number(text, speed);
    return {"slow motion, speed " + text};
}

int encoder_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

}  // namespace

FrameOutput::FrameOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options,
                         const FrameSchedule& schedule)
    : scene_(scene),
      options_(options),
      schedule_(schedule),
      camera_(make_camera(scene, world, options.size.aspect_ratio())),
      writer_(encoder_threads()),
      drawers_(scene, options, [this](Image image) { write_frame(std::move(image)); }) {
    if (!options.plot.empty()) plots_.emplace(run_plots(scene, options.plots_of(scene)));
    if (!options.video.empty())
        video_.emplace(
            start_video(options.video, video_settings(options.video, options.whole_size(), options.frames_per_second)));
    if (!options.raw_video.empty()) raw_video_.emplace(options.raw_video);
}

Image FrameOutput::image_to_draw() {
    if (!options_.no_frames) return writer_.take_image();
    if (spare_.empty()) return {};
    Image image = std::move(spare_.back());
    spare_.pop_back();
    return image;
}

void FrameOutput::write_frame(Image image) {
    const Stopwatch watch;
    if (plots_) {
        const double step = static_cast<double>(schedule_.step_of_frame(next_written_));
        image = stacked(image, plots_->at(step / schedule_.steps_per_second));
    }
    if (video_) video_->write(image);
    if (raw_video_) raw_video_->write(image);
    if (options_.no_frames)
        spare_.push_back(std::move(image));
    else
        writer_.submit(std::move(image), frame_file(options_.folder, next_written_));
    ++next_written_;
    other_seconds_ += watch.seconds();
}

void FrameOutput::draw_due(const SceneWorld& world) {
    const Stopwatch watch;
    const std::uint64_t step = world.world.step_count();
    camera_ = move_camera(camera_, scene_, world);
    record_trails(marking_.trails, scene_, world);
    other_seconds_ += watch.seconds();
    while (next_frame_ < schedule_.frame_count() && schedule_.step_of_frame(next_frame_) == step) {
        const Camera shown = apply_camera_keys(camera_, scene_, world, options_.size.aspect_ratio());
        marking_.caption = caption_at(schedule_.speed_of_frame(next_frame_));
        drawers_.draw(world, shown, marking_, image_to_draw());
        add_view(views_, view_of(shown, options_.size, next_frame_));
        ++next_frame_;
    }
}

std::vector<WrittenFiles> FrameOutput::finish() {
    std::vector<WrittenFiles> files;
    const WrittenFiles frames = finish_frames();
    if (!options_.no_frames) files.push_back(frames);
    if (video_) files.push_back({"video", options_.video, 1, video_->finish()});
    if (raw_video_) files.push_back({"raw video", options_.raw_video, 1, raw_video_->finish()});
    return files;
}

WrittenFiles FrameOutput::finish_frames() {
    drawers_.finish();
    const FrameWriter::Written written = writer_.finish();
    encode_seconds_ = written.encode_seconds;
    return {"frames", frame_file(options_.folder, 0), earlier_frames_ + written.files, earlier_bytes_ + written.bytes};
}

void FrameOutput::continue_from(State state, std::uint64_t frames, std::uint64_t bytes) {
    camera_ = state.camera;
    marking_.trails = std::move(state.trails);
    views_ = std::move(state.views);
    next_frame_ = next_written_ = earlier_frames_ = frames;
    earlier_bytes_ = bytes;
}

}  // namespace tumble::tools
