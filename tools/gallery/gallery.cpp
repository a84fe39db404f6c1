#include "tools/gallery/gallery.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <utility>

#include "tools/cli/error_report.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/scene/scene_options.hpp"
#include "tools/scene/scene_shot.hpp"

namespace tumble::tools {

namespace {

constexpr int kSheetGap = 4;  // px

void draw(GalleryEntry& entry, const GalleryOptions& options) {
    try {
        const Scene scene = load_named_scene(entry.check.file, options.check.changes);
        entry.title = scene.name;
        entry.description = scene.description;
        const std::uint64_t step =
            nearest_step(options.time.value_or(0.5 * scene.world.duration), scene.world.steps_per_second);
        Image image;
        const SceneShot shot = paint_scene_at(scene, step, {options.size, options.overlay}, {}, image);
        entry.time = shot.run.time();
        entry.picture = std::move(image);
    } catch (...) {
        if (entry.check.error.empty()) entry.picture_error = explain(std::current_exception()).message;
    }
}

}  // namespace

std::vector<GalleryEntry> make_gallery(const std::vector<std::string>& files, const GalleryOptions& options) {
    std::vector<GalleryEntry> entries;
    for (SceneCheck& check : check_scene_files(files, options.check)) {
        entries.emplace_back();
        entries.back().title = check.file;
        entries.back().check = std::move(check);
    }
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < entries.size() && !is_interrupted(); i = next++) draw(entries[i], options);
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
    return image_grid(pictures, across, kSheetGap);
}

}  // namespace tumble::tools
