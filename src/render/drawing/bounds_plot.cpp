#include "render/drawing/bounds_plot.hpp"

#include <algorithm>
#include <cmath>

#include "debug/check.hpp"
#include "render/drawing/pair_drawing.hpp"

namespace tumble::render {

void draw_bounds_panel(Drawing& drawing, PixelRect rect, const std::vector<TraceStep>& steps) {
    constexpr double kCaptionSize = 12.0;
    TUMBLE_CHECK(steps.size() >= 2);
    double top = 0.0, bottom = 0.0;
    for (const TraceStep& step : steps) top = std::max(top, step.upper);
    if (!(top > 0.0) || !std::isfinite(top)) top = 1.0;
    bottom = std::clamp(steps.front().lower, 0.0, top);
    if (bottom < 0.5 * top) bottom = 0.0;
    const double range = top > bottom ? top - bottom : 1.0;
    draw_frame(drawing, rect, "Bounds on the distance of the cores");
    const double left = rect.left + 64.0, right = rect.left + rect.width - 24.0;
    const double base = rect.top + rect.height - 48.0, height = rect.height - 96.0;
    const auto x = [&](std::size_t k) {
        return left + (right - left) * static_cast<double>(k) / static_cast<double>(steps.size() - 1);
    };
    const auto y = [&](double value) { return base - height * std::clamp((value - bottom) / range, 0.0, 1.0); };
    drawing.line({left, base}, {right, base}, 1.0, ink::kFaint);
    drawing.text({left - 8.0, base + 4.0}, short_number(bottom), kCaptionSize, ink::kText, TextAnchor::right);
    drawing.text({left - 8.0, base - height + 4.0}, short_number(top), kCaptionSize, ink::kText, TextAnchor::right);
    std::vector<DVec2> upper, lower;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        upper.push_back({x(k), y(steps[k].upper)});
        lower.push_back({x(k), y(steps[k].lower)});
        drawing.text({x(k), base + 18.0}, std::to_string(k + 1), kCaptionSize, ink::kText, TextAnchor::middle);
    }
    drawing.polyline(upper, 2.0, ink::kAnswer);
    drawing.polyline(lower, 2.0, ink::kText);
    for (const DVec2 p : upper) drawing.disc(p, 4.0, ink::kAnswer);
    for (const DVec2 p : lower) drawing.disc(p, 4.0, ink::kText);
    drawing.text({left, base + 37.0}, "lower: the thin line", kCaptionSize, ink::kText);
    drawing.text({right, base + 37.0}, "upper: |v|", kCaptionSize, ink::kAnswer, TextAnchor::right);
}

}  // namespace tumble::render
