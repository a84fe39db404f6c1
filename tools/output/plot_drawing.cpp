// Plots as drawings, which the canvas of the frames draws as images.
#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/output/plot_colors.hpp"
#include "tools/output/plot_layout.hpp"
#include "tumble/drawing.hpp"

namespace tumble::tools {

namespace {

constexpr double kTextSize = 12.0, kHeadingSize = 13.0, kLineWidth = 1.8;  // px, as in plot_style()

struct Box {
    DVec2 lower, upper;
};

struct Segment {
    DVec2 from, to;
};

// The part of a segment in the box, by Liang and Barsky.
std::optional<Segment> clipped(DVec2 from, DVec2 to, const Box& box) {
    double first = 0.0, last = 1.0;
    const auto cut = [&](double along, double room) {  // along * t <= room
        if (along == 0.0) return room >= 0.0;
        if (along > 0.0)
            last = std::min(last, room / along);
        else
            first = std::max(first, room / along);
        return first <= last;
    };
    const DVec2 d = to - from;
    if (!cut(-d.x, from.x - box.lower.x) || !cut(d.x, box.upper.x - from.x) || !cut(-d.y, from.y - box.lower.y) ||
        !cut(d.y, box.upper.y - from.y))
        return std::nullopt;
    return Segment{from + first * d, from + last * d};
}

void rectangle(Drawing& drawing, DVec2 lower, DVec2 upper, Color fill, double width, Color outline) {
    drawing.polygon({lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}, fill, width, outline);
}

// Draws one plot into a drawing, `down` px below its upper edge.
class DrawnPlot {
public:
    DrawnPlot(Drawing& drawing, const Plot& plot, double down, const PlotPage& page)
        : drawing_(drawing), plot_(plot), layout_(plot, page.least_left), down_(down), is_dark_(page.is_dark) {}

    void draw() {
        texts();
        axes();
        if (plot_.band) {
            const PlotRange band = layout_.band();
            rectangle(drawing_, at(layout_.left, band.lower), at(layout_.right, band.upper), color(kBandColor), 0.0,
                      {});
        }
        for (const PlotSeries& series : plot_.series) draw(series);
    }

private:
    DVec2 at(double x, double y) const { return {x, y + down_}; }
    Box area() const { return {at(layout_.left, layout_.top), at(layout_.right, layout_.bottom)}; }
    Color color(const PlotColor& color) const { return color_of(color, is_dark_); }
    Color text_color() const { return color(kTextColor); }

    void texts() {
        for (std::size_t line = 0; line < layout_.title.size(); ++line)
            drawing_.text(at(12.0, kFirstHeadingBase + kHeadingLine * static_cast<double>(line)), layout_.title[line],
                          kHeadingSize, text_color());
        for (const LegendEntry& entry : layout_.legend) {
            drawing_.text(at(entry.at.x + 24.0, entry.at.y), entry.name, kTextSize, text_color());
            swatch(entry);
        }
        drawing_.text(at(0.5 * (layout_.left + layout_.right), layout_.bottom + 38.0), plot_.x.label, kTextSize,
                      text_color(), TextAnchor::middle);
    }

    void swatch(const LegendEntry& entry) {
        const double x = entry.at.x, y = entry.at.y;
        if (!entry.series)
            return rectangle(drawing_, at(x, y - 11.0), at(x + 18.0, y + 1.0), color(kBandColor), 0.0, {});
        const PlotSeries& series = *entry.series;
        const Color ink = color(plot_color(series.ink));
        if (!series.bars.empty())
            rectangle(drawing_, at(x + 2.0, y - 10.0), at(x + 14.0, y), ink, 0.0, {});
        else if (series.mark == Mark::points)
            drawing_.disc(at(x + 9.0, y - 4.0), 3.5, ink);
        else
            stroke({at(x, y - 4.0), at(x + 18.0, y - 4.0)}, series.mark, ink, 0.0);
    }

    void axes() {
        const Color rule = color(kRuleColor);
        for (const PlotTick& tick : layout_.x_scale.ticks) {
            const double x = layout_.x(tick.at);
            drawing_.line(at(x, layout_.top), at(x, layout_.bottom), 1.0, rule);
            drawing_.text(at(x, layout_.bottom + 17.0), tick.label, kTextSize, text_color(), TextAnchor::middle);
        }
        for (const PlotTick& tick : layout_.y_scale.ticks) {
            const double y = layout_.y(tick.at);
            drawing_.line(at(layout_.left, y), at(layout_.right, y), 1.0, rule);
            drawing_.text(at(layout_.left - 7.0, y + 4.0), tick.label, kTextSize, text_color(), TextAnchor::right);
        }
        rectangle(drawing_, area().lower, area().upper, kTransparent, 1.0, color(kHeadColor));
    }

    // `begun` is the length of the shown line before this part of it, px.
    void stroke(const Segment& part, Mark mark, Color ink, double begun) {
        if (mark == Mark::dashed)
            drawing_.dashed_line(part.from, part.to, kLineWidth, ink, begun);
        else
            drawing_.line(part.from, part.to, kLineWidth, ink);
    }

    void draw(const PlotSeries& series) {
        const Color ink = color(plot_color(series.ink));
        const Box box = area();
        for (const PlotBar& bar : series.bars) {
            const DVec2 from = at(layout_.x(bar.left), layout_.y(bar.top));
            const DVec2 to = at(layout_.x(bar.right), layout_.y(bar.base));
            if (const auto shown = clipped(from, to, box)) rectangle(drawing_, shown->from, shown->to, ink, 0.0, {});
        }
        if (series.mark == Mark::points) {
            for (const DVec2 point : series.points) {
                if (!layout_.shows(point)) continue;
                const DVec2 center = at(layout_.x(point.x), layout_.y(point.y));
                if (clipped(center, center, box)) drawing_.disc(center, 3.0, ink);
            }
            return;
        }
        for (const std::vector<DVec2>& line : layout_.lines(series)) {
            double begun = 0.0;
            for (std::size_t i = 1; i < line.size(); ++i) {
                const DVec2 from = at(line[i - 1].x, line[i - 1].y), to = at(line[i].x, line[i].y);
                const auto shown = clipped(from, to, box);
                if (!shown) continue;
                stroke(*shown, series.mark, ink, begun);
                begun += length(shown->to - shown->from);
            }
        }
    }

    Drawing& drawing_;
    const Plot& plot_;
    PlotLayout layout_;
    double down_;
    bool is_dark_;
};

}  // namespace

Drawing to_drawing(std::span<const Plot> plots, PlotPage page) {
    page.least_left = std::max(page.least_left, common_left(plots));
    Drawing drawing;
    drawing.background = color_of(kPageColor, page.is_dark);
    for (const Plot& plot : plots) {
        DrawnPlot(drawing, plot, drawing.height, page).draw();
        drawing.width = std::max(drawing.width, plot.width);
        drawing.height += plot.height;
    }
    return drawing;
}

}  // namespace tumble::tools
