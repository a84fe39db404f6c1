#include "tools/run/frame_output.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "tools/measure/stopwatch.hpp"
#include "tools/run/run_folder.hpp"

namespace tumble::tools {

namespace {

int encoder_threads() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

}  // namespace

FrameOutput::FrameOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options,
                         const FrameSchedule& schedule)
    : scene_(scene),
      folder_(options.folder),
      schedule_(schedule),
      renderer_(options.size.width, options.size.height),
      camera_(make_camera(scene, world, options.size.aspect_ratio())),
      writer_(encoder_threads()),
      overlay_(options.overlay) {}

void FrameOutput::draw_due(const SceneWorld& world) {
    const Stopwatch watch;
    const std::uint64_t step = world.world.step_count();
    camera_ = move_camera(camera_, scene_, world);
    while (next_frame_ < schedule_.frame_count() && schedule_.step_of_frame(next_frame_) == step) {
        Image image = writer_.take_image();
        renderer_.draw(scene_, world, camera_, world.world.time(), image, overlay_);
        writer_.submit(std::move(image), frame_file(folder_, next_frame_));
        ++next_frame_;
    }
    render_seconds_ += watch.seconds();
}

WrittenFiles FrameOutput::finish() {
    const FrameWriter::Written written = writer_.finish();
    encode_seconds_ = written.encode_seconds;
    return {"frames", frame_file(folder_, 0), written.files, written.bytes};
}

}  // namespace tumble::tools
