#include "tools/compare/compared_frames.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/compare/compared_strip.hpp"
#include "tools/output/image_grid.hpp"

namespace tumble::tools {

namespace {

// The number of frames that show each step.
std::map<std::uint64_t, int> frames_of_steps(const ComparedRuns& runs, double frames_per_second) {
    std::map<std::uint64_t, int> frames;
    std::size_t step = 0;
    const double last = runs.steps.back().time;
    for (std::uint64_t frame = 0;; ++frame) {
        const double time = static_cast<double>(frame) / frames_per_second;
        if (time > last * (1.0 + 1e-12) || is_interrupted()) return frames;
        while (step + 1 < runs.steps.size() &&
               std::abs(runs.steps[step + 1].time - time) <= std::abs(runs.steps[step].time - time))
            ++step;
        ++frames[runs.steps[step].step];
    }
}

std::filesystem::path frame_in(const std::filesystem::path& folder, std::uint64_t frame) {
    std::array<char, 40> name{};
    std::snprintf(name.data(), name.size(), "frame_%06llu.png", static_cast<unsigned long long>(frame));
    return folder / name.data();
}

// The sinks of the frames that are wanted.
class FrameSinks {
public:
    FrameSinks(const ComparedFrames& options, std::uint64_t frames) : options_(options) {
        if (!options.folder.empty()) {
            std::filesystem::create_directories(options.folder);
            writer_.emplace(kEncoders);
        }
        if (options.video.empty()) return;
        const VideoSettings settings = compared_video(options);
        require_memory(settings, frames);
        video_.emplace(start_video(options.video, settings));
    }

    void write(const Image& image) {
        if (video_) video_->write(image);
        if (writer_) writer_->submit(image, frame_in(options_.folder, count_));
        ++count_;
    }

    std::uint64_t finish() {
        if (writer_) writer_->finish();
        if (video_ && count_ > 0) video_->finish();
        return count_;
    }

private:
    static constexpr int kEncoders = 2;  // threads

    const ComparedFrames& options_;
    std::optional<FrameWriter> writer_;
    std::optional<VideoWriter> video_;
    std::uint64_t count_ = 0;
};

// With the plots below the pictures.
FrameSize whole_size(const PairPictures& pictures) {
    const FrameSize pair = pair_size(pictures);
    return {pair.width, pair.height + compared_strip_height(pictures)};
}

}  // namespace

VideoSettings compared_video(const ComparedFrames& options) {
    return video_settings(options.video, whole_size(options.pictures), options.frames_per_second);
}

std::uint64_t write_frames(const CompareInputs& inputs, const ComparedRuns& runs, const ComparedFrames& options) {
    const ComparedSources sources = open_sources(inputs);
    if (runs.steps.empty() || !sources.a->built() || !sources.b->built()) return 0;
    const std::map<std::uint64_t, int> wanted = frames_of_steps(runs, options.frames_per_second);
    std::uint64_t frames = 0;
    for (const auto& [step, count] : wanted) frames += static_cast<std::uint64_t>(count);
    const PlotStrip strip =
        compared_strip(runs, options.pictures, is_dark(theme_of(*sources.a->scene(), options.pictures)));
    FrameSinks sinks(options, frames);
    Progress progress("frames", frames);
    std::uint64_t drawn = 0;
    draw_pairs(
        inputs, options.pictures, [&](std::uint64_t step) { return wanted.contains(step); },
        [&](const PairPicture& picture) {
            const Image whole = stacked(picture.image, strip.at(picture.time));
            for (int copy = 0; copy < wanted.at(picture.step); ++copy, ++drawn) sinks.write(whole);
            progress.show(drawn);
        });
    return sinks.finish();
}

}  // namespace tumble::tools
