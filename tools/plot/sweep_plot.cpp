#include "tools/plot/sweep_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "tools/output/csv_table.hpp"
#include "tools/output/input_error.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/plot.hpp"

namespace tumble::tools {

namespace {

constexpr double kLeft = 80, kTop = 30, kSize = 480, kBottom = 60, kRight = 30, kScale = 110;  // px
constexpr std::size_t kMostCells = 200;  // of a grid, in one direction
constexpr std::size_t kGathered = 40;    // cells of drawn values
constexpr Color kInk{40, 44, 52}, kDot{45, 98, 164, 150};

struct Sample {
    double x = 0.0, y = 0.0, value = 0.0;
};

struct Range {
    double lower = 0.0, upper = 0.0;

    // From 0 to 1; the middle if the range is a single number, or beyond double.
    double part(double number) const {
        const double part = (number - lower) / (upper - lower);
        return part >= 0.0 && part <= 1.0 ? part : 0.5;
    }
};

// The lines with a number in each of the columns; y is 0 without a column of it.
std::vector<Sample> read_samples(const std::filesystem::path& table, const SweepPlot& plot) {
    CsvTable rows(table);
    const bool has_y = !plot.y.empty();
    const std::size_t x = rows.column(plot.x), y = has_y ? rows.column(plot.y) : x, value = rows.column(plot.value);
    std::vector<Sample> samples;
    while (rows.next()) {
        const auto number_in = [&](std::size_t column) { return number_of(rows.cell(column)).value_or(std::nan("")); };
        const Sample sample{number_in(x), has_y ? number_in(y) : 0.0, number_in(value)};
        if (std::isfinite(sample.x) && std::isfinite(sample.y) && std::isfinite(sample.value))
            samples.push_back(sample);
    }
    if (samples.empty()) throw InputError(table.string() + ": no line has a number in each of the columns");
    return samples;
}

Range range_of(const std::vector<Sample>& samples, double Sample::*member) {
    const auto [lower, upper] = std::ranges::minmax(samples, {}, member);
    return {lower.*member, upper.*member};
}

// Dark blue, green, yellow: five colours of viridis, mixed.
Color color_of(double part) {
    constexpr std::array<std::array<double, 3>, 5> kColors{
        {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
    const double place = std::clamp(part, 0.0, 1.0) * 4.0;
    const auto index = std::min<std::size_t>(3, static_cast<std::size_t>(place));
    const auto mixed = [&](std::size_t channel) {
        const double from = kColors[index][channel], to = kColors[index + 1][channel];
        return static_cast<std::uint8_t>(std::lround(from + (to - from) * (place - static_cast<double>(index))));
    };
    return {mixed(0), mixed(1), mixed(2)};
}

void draw_box(Drawing& drawing, double left, double top, double width, double height, Color fill) {
    drawing.polygon({{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}}, fill, 0.0,
                    {});
}

// Ticks and names of both axes; `margin` is the part of a cell between an end of the range and the frame.
void draw_axes(Drawing& drawing, const SweepPlot& plot, Range x, Range y, double margin_x, double margin_y) {
    constexpr int kMostTicks = 6;
    for (const PlotTick& tick : round_ticks({x.lower, x.upper}, kMostTicks)) {
        const double at = kLeft + kSize * (margin_x + (1.0 - 2.0 * margin_x) * x.part(tick.at));
        drawing.line({at, kTop + kSize}, {at, kTop + kSize + 5}, 1.0, kInk);
        drawing.text({at, kTop + kSize + 20}, tick.label, 13, kInk, TextAnchor::middle);
    }
    for (const PlotTick& tick : round_ticks({y.lower, y.upper}, kMostTicks)) {
        const double at = kTop + kSize * (1.0 - margin_y - (1.0 - 2.0 * margin_y) * y.part(tick.at));
        drawing.line({kLeft - 5, at}, {kLeft, at}, 1.0, kInk);
        drawing.text({kLeft - 8, at + 4}, tick.label, 13, kInk, TextAnchor::right);
    }
    drawing.text({kLeft + kSize / 2, kTop + kSize + 45}, plot.x, 15, kInk, TextAnchor::middle);
    drawing.text({kLeft - 60, kTop - 10}, plot.y.empty() ? plot.value : plot.y, 15, kInk);
}

void draw_scale(Drawing& drawing, const std::string& name, Range values) {
    constexpr int kSteps = 64;
    const double left = kLeft + kSize + 25, step = kSize / kSteps;
    for (int i = 0; i < kSteps; ++i)
        draw_box(drawing, left, kTop + kSize - (i + 1) * step, 18, step + 0.5, color_of((i + 0.5) / kSteps));
    drawing.text({left + 24, kTop + kSize}, four_digits(values.lower), 13, kInk);
    drawing.text({left + 24, kTop + 10}, four_digits(values.upper), 13, kInk);
    drawing.text({left, kTop - 10}, name, 15, kInk);
}

// The cells of an axis: one for each value on a grid, else kGathered of equal size.
std::size_t count_cells(const std::vector<Sample>& samples, double Sample::*member) {
    std::set<double> values;
    for (const Sample& sample : samples)
        if (values.size() <= kMostCells) values.insert(sample.*member);
    return values.size() > kMostCells || values.size() * values.size() > samples.size() * 4 ? kGathered : values.size();
}

void draw_heat_map(Drawing& drawing, const SweepPlot& plot, const std::vector<Sample>& samples) {
    const Range x = range_of(samples, &Sample::x), y = range_of(samples, &Sample::y);
    const std::size_t columns = count_cells(samples, &Sample::x), rows = count_cells(samples, &Sample::y);
    std::vector<double> sums(columns * rows), counts(columns * rows);
    const auto cell_of = [](double part, std::size_t count) {
        return std::min(count - 1, static_cast<std::size_t>(std::lround(part * static_cast<double>(count - 1))));
    };
    for (const Sample& sample : samples) {
        const std::size_t cell = cell_of(y.part(sample.y), rows) * columns + cell_of(x.part(sample.x), columns);
        sums[cell] += sample.value;
        counts[cell] += 1.0;
    }
    Range values{INFINITY, -INFINITY};
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (counts[i] == 0.0) continue;
        sums[i] /= counts[i];
        values = {std::min(values.lower, sums[i]), std::max(values.upper, sums[i])};
    }
    const double width = kSize / static_cast<double>(columns), height = kSize / static_cast<double>(rows);
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (counts[i] > 0.0)
            draw_box(drawing, kLeft + width * static_cast<double>(i % columns),
                     kTop + kSize - height * static_cast<double>(i / columns + 1), width, height,
                     color_of(values.part(sums[i])));
    draw_axes(drawing, plot, x, y, 0.5 / static_cast<double>(columns), 0.5 / static_cast<double>(rows));
    draw_scale(drawing, plot.value, values);
}

void draw_dots(Drawing& drawing, const SweepPlot& plot, const std::vector<Sample>& samples) {
    const Range x = range_of(samples, &Sample::x), values = range_of(samples, &Sample::value);
    constexpr double kMargin = 0.02;
    // Few dots are large enough to be seen, and many do not cover each other.
    const double radius = std::clamp(40.0 / std::sqrt(static_cast<double>(samples.size())), 1.5, 4.0);
    const auto placed = [](double part) { return kSize * (kMargin + (1.0 - 2.0 * kMargin) * part); };
    for (const Sample& sample : samples)
        drawing.disc({kLeft + placed(x.part(sample.x)), kTop + kSize - placed(values.part(sample.value))}, radius,
                     kDot);
    draw_axes(drawing, plot, x, values, kMargin, kMargin);
}

}  // namespace

Drawing draw_sweep(const std::filesystem::path& table, const SweepPlot& plot) {
    const std::vector<Sample> samples = read_samples(table, plot);
    Drawing drawing{.width = static_cast<int>(kLeft + kSize + (plot.y.empty() ? kRight : kScale)),
                    .height = static_cast<int>(kTop + kSize + kBottom)};
    plot.y.empty() ? draw_dots(drawing, plot, samples) : draw_heat_map(drawing, plot, samples);
    for (const auto& [from, to] : {std::pair<DVec2, DVec2>{{kLeft, kTop + kSize}, {kLeft + kSize, kTop + kSize}},
                                   {{kLeft, kTop}, {kLeft, kTop + kSize}}})
        drawing.line(from, to, 1.0, kInk);
    return drawing;
}

}  // namespace tumble::tools
