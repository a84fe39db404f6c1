#include "tools/run/frame_output.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "tools/measure/stopwatch.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/video_output.hpp"

namespace tumble::tools {

namespace {

int encoder_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

}  // namespace

FrameOutput::FrameOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options,
                         const FrameSchedule& schedule)
    : scene_(scene),
      options_(options),
      schedule_(schedule),
      renderer_(options.size.width, options.size.height, options.renderer),
      camera_(make_camera(scene, world, options.size.aspect_ratio())),
      writer_(encoder_threads()),
      overlay_(options.overlay) {
    if (!options.video.empty())
        video_.emplace(
            start_video(options.video, video_settings(options.video, options.size, options.frames_per_second)));
    if (!options.raw_video.empty()) raw_video_.emplace(options.raw_video);
}

void FrameOutput::write_frame(Image image) {
    if (video_) video_->write(image);
    if (raw_video_) raw_video_->write(image);
    if (options_.no_frames)
        image_ = std::move(image);
    else
        writer_.submit(std::move(image), frame_file(options_.folder, next_frame_));
}

void FrameOutput::draw_due(const SceneWorld& world) {
    const Stopwatch watch;
    const std::uint64_t step = world.world.step_count();
    camera_ = move_camera(camera_, scene_, world);
    record_trails(marking_.trails, scene_, world);
    while (next_frame_ < schedule_.frame_count() && schedule_.step_of_frame(next_frame_) == step) {
        Image image = options_.no_frames ? std::move(image_) : writer_.take_image();
        renderer_.draw(scene_, world, camera_, world.world.time(), image, overlay_, marking_);
        add_view(views_, view_of(camera_, options_.size, next_frame_));
        write_frame(std::move(image));
        ++next_frame_;
    }
    render_seconds_ += watch.seconds();
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
    const FrameWriter::Written written = writer_.finish();
    encode_seconds_ = written.encode_seconds;
    return {"frames", frame_file(options_.folder, 0), earlier_frames_ + written.files, earlier_bytes_ + written.bytes};
}

void FrameOutput::continue_from(State state, std::uint64_t frames, std::uint64_t bytes) {
    camera_ = state.camera;
    marking_.trails = std::move(state.trails);
    views_ = std::move(state.views);
    next_frame_ = earlier_frames_ = frames;
    earlier_bytes_ = bytes;
}

}  // namespace tumble::tools
