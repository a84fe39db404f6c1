// Round numbers for the ticks of axes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tools/output/plot.hpp"

namespace tumble::tools {

namespace {

// "0.05", "1200", "1e-6": at most 6 digits, which tells neighbouring ticks apart.
std::string tick_label(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    std::string label = text.data();
    for (const char* const padded : {"e-0", "e+0"})
        if (const std::size_t at = label.find(padded); at != std::string::npos) label.erase(at + 2, 1);
    if (const std::size_t plus = label.find('+'); plus != std::string::npos) label.erase(plus, 1);
    return label;
}

double round_step(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
    return 10.0 * decade;
}

void add_if_inside(std::vector<PlotTick>& ticks, PlotRange range, double value) {
    if (value >= range.lower * (1.0 - 1e-9) && value <= range.upper * (1.0 + 1e-9))
        ticks.push_back({value, tick_label(value)});
}

}  // namespace

std::vector<PlotTick> round_ticks(PlotRange range, int most) {
    const double size = range.upper - range.lower, largest = std::max(std::abs(range.lower), std::abs(range.upper));
    const double step = round_step(size / most);
    // In a shorter range the labels are equal, and steps are lost in the rounding.
    if (!(size > 1e-9 * largest) || !(step > 0.0) || !std::isfinite(step))
        return {{range.lower, tick_label(range.lower)}};
    std::vector<PlotTick> ticks;
    const double last = std::floor(range.upper / step + 1e-6);
    for (double k = std::ceil(range.lower / step - 1e-6); k <= last; ++k)
        ticks.push_back({k * step, tick_label(k == 0.0 ? 0.0 : k * step)});
    return ticks;
}

std::vector<PlotTick> decade_ticks(PlotRange range, int most) {
    const int first = static_cast<int>(std::floor(std::log10(range.lower)));
    const int last = static_cast<int>(std::ceil(std::log10(range.upper)));
    const int stride = std::max(1, (last - first + most - 1) / most);
    std::vector<PlotTick> ticks;
    for (int decade = first; decade <= last; decade += stride) add_if_inside(ticks, range, std::pow(10.0, decade));
    if (ticks.size() >= 2) return ticks;
    ticks.clear();
    for (int decade = first; decade <= last; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) add_if_inside(ticks, range, factor * std::pow(10.0, decade));
    return ticks;
}

}  // namespace tumble::tools
