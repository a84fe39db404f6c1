#include "tools/parity/parity_plots.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble::tools {

namespace {

using reference::ErrorHistogram;
using reference::ParityRow;

constexpr int kFirstDecade = -20;  // at the first of two bins per decade; errors of 0 are counted there too
constexpr int kStrip = 44;         // px, height of a family's strip, both halves
constexpr int kFrame = 102;        // px, title, legend, ticks and label
constexpr double kHalf = 0.42;     // the longest bar, as a part of a strip
constexpr double kGap = 0.08;      // between bars, as a part of a bin

double decade_of(double bin) { return kFirstDecade + 0.5 * bin; }

// The square root keeps a few bad pairs visible among thousands of good ones.
double bar_length(std::uint64_t count, std::uint64_t largest) {
    const double share = std::sqrt(static_cast<double>(count) / static_cast<double>(largest));
    return std::max(0.03, share * kHalf);
}

void add_bars(PlotSeries& series, const ErrorHistogram& histogram, double base, double sign) {
    const std::uint64_t largest = *std::max_element(histogram.counts.begin(), histogram.counts.end());
    for (int bin = 0; bin < ErrorHistogram::kBins; ++bin) {
        const std::uint64_t count = histogram.counts[static_cast<std::size_t>(bin)];
        if (count == 0) continue;
        series.bars.push_back({.left = decade_of(bin + kGap),
                               .right = decade_of(bin + 1 - kGap),
                               .base = base,
                               .top = base + sign * bar_length(count, largest)});
    }
}

PlotAxis error_axis() {
    PlotAxis axis{.label = "|error of the distance| / S",
                  .range = PlotRange{decade_of(0), decade_of(ErrorHistogram::kBins)}};
    axis.ticks.push_back({kFirstDecade, "0"});
    for (int decade = kFirstDecade + 2; decade <= 2; decade += 2)
        axis.ticks.push_back({static_cast<double>(decade), "1e" + std::to_string(decade)});
    return axis;
}

}  // namespace

Plot plot_error_histograms(std::span<const ParityRow> families) {
    const double count = static_cast<double>(families.size());
    PlotSeries ours{.name = "tumble, upwards", .ink = Ink::tumble};
    PlotSeries box2d{.name = "Box2D, downwards", .ink = Ink::box2d};
    PlotAxis strips{.label = "", .range = PlotRange{0.0, count}};
    double base = count - 0.5;
    for (const ParityRow& family : families) {
        strips.ticks.push_back({base, family.name});
        add_bars(ours, family.histogram_ours, base, 1.0);
        add_bars(box2d, family.histogram_box2d, base, -1.0);
        base -= 1.0;
    }
    const double limit = std::log10(reference::kParityTolerance * reference::kFloatEpsilon);
    PlotSeries line{.name = "4 eps S", .ink = Ink::limit, .mark = Mark::dashed};
    line.points = {{limit, 0.0}, {limit, count}};
    return {.title = "Errors of both engines by family",
            .x = error_axis(),
            .y = strips,
            .series = {ours, box2d, line},
            .width = 1280,
            .height = kFrame + kStrip * static_cast<int>(families.size())};
}

}  // namespace tumble::tools
