#include "tools/gallery/gallery.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <utility>

#include "tools/cli/console.hpp"
#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tools/run/video_output.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/scene/scene_shot.hpp"

namespace tumble::tools {

namespace {

constexpr int kSheetGap = 4;  // px

constexpr double kLoopRate = 20.0;  // frames per second

VideoSettings loop_settings(const GalleryOptions& options) {
    return {.format = VideoFormat::gif,
            .width = options.size.width,
            .height = options.size.height,
            .frames_per_second = kLoopRate};
}

std::uint64_t loop_frames(const GalleryOptions& options) {
    return FrameSchedule{*options.loop, kLoopRate, kLoopRate}.frame_count();
}

// Draws the frames of a loop, which begins at that step.
void write_loop(const Scene& scene, std::uint64_t first, const GalleryOptions& options,
                const std::filesystem::path& file) {
    const FrameSchedule schedule{*options.loop, kLoopRate, scene.world.steps_per_second};
    VideoWriter video = start_video(file, loop_settings(options));
    SceneFrames frames(scene, {options.size, options.overlay, options.check.renderer});
    for (std::uint64_t frame = 0; frame < schedule.frame_count() && !is_interrupted(); ++frame)
        video.write(frames.at(first + schedule.step_of_frame(frame)));
    if (!is_interrupted()) video.finish();
}

// "3-bridge.gif": the number separates scenes with equal names.
std::filesystem::path loop_name(const GalleryEntry& entry, std::size_t number) {
    return std::to_string(number + 1) + "-" + entry.check.name + ".gif";
}

void draw(GalleryEntry& entry, std::size_t number, const GalleryOptions& options) {
    try {
        const Scene scene = load_named_scene(entry.check.file, options.check.changes);
        entry.title = scene.name;
        entry.description = scene.description;
        const std::uint64_t step =
            nearest_step(options.time.value_or(0.5 * scene.world.duration), scene.world.steps_per_second);
        Image image;
        const SceneShot shot =
            paint_scene_at(scene, step, {options.size, options.overlay, options.check.renderer}, {}, image);
        entry.time = shot.run.time();
        entry.picture = std::move(image);
        if (!options.loop) return;
        const std::filesystem::path name = loop_name(entry, number);
        write_loop(scene, step, options, options.loops / name);
        entry.loop = name;
    } catch (...) {
        if (entry.check.error.empty()) entry.picture_error = explain(std::current_exception()).message;
    }
}

}  // namespace

int affordable_threads(const GalleryOptions& options) {
    const int threads = options.check.threads;
    return options.loop ? gifs_at_a_time(video_bytes(loop_settings(options), loop_frames(options)), threads) : threads;
}

void require_loops(const GalleryOptions& options, std::size_t scenes) {
    require_encoder();
    const std::size_t at_a_time = std::min(scenes, static_cast<std::size_t>(options.check.threads));
    require_memory(
        loop_settings(options), loop_frames(options), at_a_time, "--loop",
        at_a_time == 1 ? "lower --size, or shorten the loops" : "lower --jobs or --size, or shorten the loops");
}

std::vector<GalleryEntry> make_gallery(const std::vector<std::string>& files, const GalleryOptions& options) {
    std::vector<GalleryEntry> entries;
    for (SceneCheck& check : check_scene_files(files, options.check)) {
        entries.emplace_back();
        entries.back().title = check.file;
        entries.back().check = std::move(check);
    }
    std::atomic<std::size_t> next = 0, done = 0;
    Progress progress("scenes drawn", entries.size());
    const auto work = [&] {
        for (std::size_t i = next++; i < entries.size() && !is_interrupted(); i = next++) {
            draw(entries[i], i, options);
            progress.show(++done);
        }
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < options.check.threads; ++i) others.emplace_back(work);
    work();
    others.clear();
    return entries;
}

std::optional<Image> contact_sheet(const std::vector<GalleryEntry>& entries, int columns) {
    std::vector<Image> pictures;
    for (const GalleryEntry& entry : entries)
        if (entry.picture) pictures.push_back(*entry.picture);
    if (pictures.empty()) return std::nullopt;
    const int across = std::clamp((kLargestFrame + kSheetGap) / (pictures.front().width + kSheetGap), 1, columns);
    const int rows = std::max(1, (kLargestFrame + kSheetGap) / (pictures.front().height + kSheetGap));
    pictures.resize(std::min(pictures.size(), static_cast<std::size_t>(across) * static_cast<std::size_t>(rows)));
    return image_grid(pictures, across, kSheetGap, {255, 255, 255});
}

}  // namespace tumble::tools
