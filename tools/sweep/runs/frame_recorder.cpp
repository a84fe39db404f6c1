#include "tools/sweep/runs/frame_recorder.hpp"

#include <array>
#include <cstdio>

namespace tumble::tools {

namespace {

double aspect_ratio(const sweep::Pictures& pictures) {
    return static_cast<double>(pictures.width) / static_cast<double>(pictures.height);
}

std::string picture_suffix(const char* kind, std::uint64_t step) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%s.%06llu.png", kind, static_cast<unsigned long long>(step));
    return text.data();
}

}  // namespace

std::string frame_software(const sweep::Written& written) {
    if (!written.has_frames()) return "";
    const BackendCheck check = check_backend(RenderBackend::automatic);
    if (!check.works) throw RenderError(check.error);
    return check.version + ", " + check.renderer + (written.frames.is_video ? ", " + encoder_version() : "");
}

FrameRecorder::FrameRecorder(const sweep::Written& written) : written_(written) {
    const sweep::Pictures &frames = written.frames, &masks = written.masks;
    if (written.has_frames()) renderer_.emplace(frames.width, frames.height);
    if (masks.every > 0) labeller_.emplace(masks.width, masks.height);
    for (const OverlayPart& part : kFrameParts) overlay_.*part.member = !frames.is_plain;
}

void FrameRecorder::start(const Scene& scene, const SceneWorld& built) {
    if (renderer_) frame_camera_ = make_camera(scene, built, aspect_ratio(written_.frames));
    if (labeller_) mask_camera_ = make_camera(scene, built, aspect_ratio(written_.masks));
    const sweep::Pictures& frames = written_.frames;
    video_.reset();
    if (frames.is_video)
        video_.emplace(frames.width, frames.height, scene.world.steps_per_second / static_cast<double>(frames.every));
}

void FrameRecorder::record(const Scene& scene, const SceneWorld& built, std::uint64_t step,
                           std::vector<std::pair<std::string, std::string>>& members) {
    if (renderer_) frame_camera_ = move_camera(frame_camera_, scene, built);
    if (labeller_) mask_camera_ = move_camera(mask_camera_, scene, built);
    if (written_.frames.are_due(step)) {
        const Camera camera = apply_camera_keys(frame_camera_, scene, built, aspect_ratio(written_.frames));
        renderer_->draw(scene, built, camera, built.world.time(), image_, overlay_);
        if (video_)
            video_->write(image_);
        else
            members.emplace_back(picture_suffix("frame", step), to_png(image_));
    }
    if (!written_.masks.are_due(step)) return;
    const Camera camera = apply_camera_keys(mask_camera_, scene, built, aspect_ratio(written_.masks));
    members.emplace_back(picture_suffix("mask", step), to_png(labeller_->label(scene, built, camera).mask));
}

void FrameRecorder::finish(std::vector<std::pair<std::string, std::string>>& members) {
    if (video_) members.emplace_back("frames.mp4", video_->finish());
    video_.reset();
}

}  // namespace tumble::tools
