#include "tools/parity/parity_plots.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tumble::tools {

namespace {

using reference::ErrorHistogram;
using reference::ParityRow;

constexpr Color kText{38, 50, 56};
constexpr Color kGrid{224, 230, 234};
constexpr Color kOurs{30, 108, 181};
constexpr Color kBox2d{214, 110, 20};
constexpr Color kLimit{198, 40, 40};

constexpr double kLeft = 210.0, kRight = 1250.0;  // ends of the axis, px
constexpr double kTop = 64.0;
constexpr double kStrip = 44.0;  // height of a family's strip, both halves
constexpr int kFirstDecade = -20;

double x_of_bin(double bin) { return kLeft + (kRight - kLeft) * bin / ErrorHistogram::kBins; }
double x_of(double relative_error) { return x_of_bin(2.0 * (std::log10(relative_error) - kFirstDecade)); }

// The square root keeps a few bad pairs visible among thousands of good ones.
double bar(std::uint64_t count, std::uint64_t largest) {
    if (count == 0) return 0.0;
    const double share = std::sqrt(static_cast<double>(count) / static_cast<double>(largest));
    return std::max(1.5, share * (0.5 * kStrip - 4.0));
}

void draw_bars(Drawing& drawing, const ErrorHistogram& histogram, double base, double sign, Color color) {
    const std::uint64_t largest = *std::max_element(histogram.counts.begin(), histogram.counts.end());
    for (int bin = 0; bin < ErrorHistogram::kBins; ++bin) {
        const double height = bar(histogram.counts[static_cast<std::size_t>(bin)], largest);
        if (height == 0.0) continue;
        const double left = x_of_bin(bin) + 0.5, right = x_of_bin(bin + 1) - 0.5, end = base - sign * height;
        drawing.polygon({{left, base}, {right, base}, {right, end}, {left, end}}, color, 0.0, color);
    }
}

}  // namespace

Drawing draw_error_histograms(std::span<const ParityRow> families) {
    Drawing drawing;
    drawing.width = 1280;
    const double bottom = kTop + kStrip * static_cast<double>(families.size());
    drawing.height = static_cast<int>(bottom + 44.0);
    for (int decade = kFirstDecade; decade <= 2; decade += 2) {
        const double x = x_of_bin(2.0 * (decade - kFirstDecade));
        drawing.line({x, kTop - 6.0}, {x, bottom}, 1.0, kGrid);
        const std::string label = decade == kFirstDecade ? "0" : "1e" + std::to_string(decade);
        drawing.text({x, bottom + 18.0}, label, 12.0, kText, TextAnchor::middle);
        if (families.size() > 10) drawing.text({x, kTop - 10.0}, label, 12.0, kText, TextAnchor::middle);
    }
    drawing.text({0.5 * (kLeft + kRight), bottom + 38.0}, "|error of the distance| / S", 13.0, kText,
                 TextAnchor::middle);
    drawing.text({kLeft, 20.0}, "tumble, upwards", 13.0, kOurs);
    drawing.text({kLeft + 140.0, 20.0}, "Box2D, downwards", 13.0, kBox2d);
    const double limit = x_of(reference::kParityTolerance * reference::kFloatEpsilon);
    drawing.dashed_line({limit, kTop - 24.0}, {limit, bottom}, 1.5, kLimit);
    drawing.text({limit, kTop - 28.0}, "4 eps S", 12.0, kLimit, TextAnchor::middle);
    double base = kTop + 0.5 * kStrip;
    for (const ParityRow& family : families) {
        drawing.line({kLeft, base}, {kRight, base}, 1.0, kGrid);
        drawing.text({kLeft - 12.0, base + 5.0}, family.name, 12.0, kText, TextAnchor::right);
        draw_bars(drawing, family.histogram_ours, base, 1.0, kOurs);
        draw_bars(drawing, family.histogram_box2d, base, -1.0, kBox2d);
        base += kStrip;
    }
    return drawing;
}

}  // namespace tumble::tools
