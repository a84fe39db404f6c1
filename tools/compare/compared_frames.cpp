#include "tools/compare/compared_frames.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "tools/compare/compared_page.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/output/plot_layout.hpp"

namespace tumble::tools {

namespace {

constexpr int kStripHeight = 180;  // px
constexpr Color kTimeColor{198, 40, 40, 255};

// The plot below the frames, drawn once; a frame adds the line of its time.
class Strip {
public:
    Strip(const ComparedRuns& runs, int width)
        : plot_(distance_plot(runs, width, kStripHeight)),
          layout_(plot_),
          image_(draw_image(to_drawing(std::vector<Plot>{plot_}))) {}

    Image at(double time) const {
        Image image = image_;
        const int x = static_cast<int>(std::lround(layout_.x(time)));
        for (const int column : {x, x + 1})
            paint_column(image, column, static_cast<int>(layout_.top), static_cast<int>(layout_.bottom), kTimeColor);
        return image;
    }

private:
    Plot plot_;
    PlotLayout layout_;
    Image image_;
};

// The number of frames that show each step.
std::map<std::uint64_t, int> frames_of_steps(const ComparedRuns& runs, double frames_per_second) {
    std::map<std::uint64_t, int> frames;
    std::size_t step = 0;
    const double last = runs.steps.back().time;
    for (std::uint64_t frame = 0;; ++frame) {
        const double time = static_cast<double>(frame) / frames_per_second;
        if (time > last * (1.0 + 1e-12)) return frames;
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

}  // namespace

std::uint64_t write_frames(const CompareInputs& inputs, const ComparedRuns& runs, const ComparedFrames& options) {
    if (runs.steps.empty()) return 0;
    const std::map<std::uint64_t, int> wanted = frames_of_steps(runs, options.frames_per_second);
    std::optional<Strip> strip;
    FrameWriter writer(2);
    std::uint64_t frame = 0;
    draw_pairs(
        inputs, options.pictures, [&](std::uint64_t step) { return wanted.contains(step); },
        [&](const PairPicture& picture) {
            if (!strip) strip.emplace(runs, picture.image.width);
            const Image whole = stacked(picture.image, strip->at(picture.time));
            for (int copy = 0; copy < wanted.at(picture.step); ++copy)
                writer.submit(whole, frame_in(options.folder, frame++));
        });
    writer.finish();
    return frame;
}

}  // namespace tumble::tools
