// One function for each element (SVG 1.1, chapter 9); all draw into the same Flattener.
#include "import/svg/svg_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/svg/svg_path.hpp"
#include "import/svg/svg_text.hpp"
#include "scene/model/degrees.hpp"

namespace tumble::scene {

namespace {

// In [-90, 90) degrees, because a box has a symmetry of half a turn.
double box_angle(DVec2 direction) {
    const double degrees = arc_tangent(direction.y, direction.x) * kDegrees;
    if (degrees >= 90.0) return degrees - 180.0;
    return degrees < -90.0 ? degrees + 180.0 : degrees + 0.0;
}

class FigureReader {
public:
    FigureReader(const pugi::xml_node& element, const Affine& map, const SvgViewport& viewport, double tolerance)
        : element_(element), map_(map), viewport_(viewport), out_(map, tolerance) {}

    SvgFigure run() {
        const std::string_view tag = element_.name();
        if (tag == "rect") read_rect();
        if (tag == "circle" || tag == "ellipse") read_ellipse(tag == "circle");
        if (tag == "line") read_line();
        if (tag == "polyline" || tag == "polygon") read_points(tag == "polygon");
        if (tag == "path") read_path(element_.attribute("d").value(), out_);
        figure_.contours = out_.take();
        return std::move(figure_);
    }

private:
    // The value of a length attribute, 0 if it is missing.
    double length_of(const char* name, double whole) const {
        const std::string_view text = trimmed(element_.attribute(name).value());
        if (text.empty() || text == "auto") return 0.0;
        try {
            return parse_length(text, whole);
        } catch (const SvgError& error) {
            throw SvgError(std::string(name) + ": " + error.what());
        }
    }

    double along_x(const char* name) const { return length_of(name, viewport_.size.x); }
    double along_y(const char* name) const { return length_of(name, viewport_.size.y); }

    double size_of(const char* name, double whole) const {
        const double size = length_of(name, whole);
        if (size < 0.0) throw SvgError(std::string(name) + " must not be negative");
        return size;
    }

    bool has(const char* name) const { return !trimmed(element_.attribute(name).value()).empty(); }

    void read_rect() {
        const DVec2 corner(along_x("x"), along_y("y"));
        const DVec2 size(size_of("width", viewport_.size.x), size_of("height", viewport_.size.y));
        if (size.x == 0.0 || size.y == 0.0) return;
        DVec2 radii(size_of("rx", viewport_.size.x), size_of("ry", viewport_.size.y));
        if (!has("rx")) radii.x = radii.y;
        if (!has("ry")) radii.y = radii.x;
        radii = {std::min(radii.x, 0.5 * size.x), std::min(radii.y, 0.5 * size.y)};
        draw_rect(corner, corner + size, radii);
        const bool round = radii.x == radii.y || radii.x == 0.0 || radii.y == 0.0;
        if (!round || !is_similarity(map_)) return;
        const double scale = length(map_.x_axis);
        figure_.position = apply(map_, corner + 0.5 * size);
        figure_.exact = BoxGeometry{scale * size, scale * std::min(radii.x, radii.y), {}, box_angle(map_.x_axis)};
    }

    void draw_rect(DVec2 low, DVec2 high, DVec2 radii) {
        const std::array<DVec2, 4> corners{low, DVec2(high.x, low.y), high, DVec2(low.x, high.y)};
        const bool round = radii.x > 0.0 && radii.y > 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            // The arc of the corner starts at the end of the previous side and ends at the start of the next.
            const DVec2 inward(corners[i].x == low.x ? radii.x : -radii.x, corners[i].y == low.y ? radii.y : -radii.y);
            const DVec2 first = corners[i] + (i % 2 == 0 ? DVec2(0.0, inward.y) : DVec2(inward.x, 0.0));
            const DVec2 last = corners[i] + (i % 2 == 0 ? DVec2(inward.x, 0.0) : DVec2(0.0, inward.y));
            const DVec2 start = round ? first : corners[i];
            i == 0 ? out_.move_to(start) : out_.line_to(start);
            if (!round) continue;
            const DVec2 center = corners[i] + inward;
            out_.arc_to({center, first - center, last - center, 0.0, 0.5 * kPi}, last);
        }
        out_.close();
    }

    void read_ellipse(bool circle) {
        const DVec2 center(along_x("cx"), along_y("cy"));
        const double diagonal = std::sqrt(0.5) * length(viewport_.size);
        DVec2 radii;
        if (circle)
            radii.x = radii.y = size_of("r", diagonal);
        else
            radii = {size_of("rx", viewport_.size.x), size_of("ry", viewport_.size.y)};
        if (!circle && !has("rx")) radii.x = radii.y;
        if (!circle && !has("ry")) radii.y = radii.x;
        if (radii.x == 0.0 || radii.y == 0.0) return;
        const DVec2 start = center + DVec2(radii.x, 0.0);
        out_.move_to(start);
        out_.arc_to({center, {radii.x, 0.0}, {0.0, radii.y}, 0.0, 2.0 * kPi}, start);
        out_.close();
        if (radii.x != radii.y || !is_similarity(map_)) return;
        figure_.position = apply(map_, center);
        figure_.exact = CircleGeometry{length(map_.x_axis) * radii.x, {}};
    }

    void read_line() {
        out_.move_to({along_x("x1"), along_y("y1")});
        out_.line_to({along_x("x2"), along_y("y2")});
    }

    void read_points(bool closed) {
        SvgScanner scanner(element_.attribute("points").value());
        for (bool first = true; !scanner.at_end(); first = false) {
            const double x = scanner.number();
            const DVec2 point(x, scanner.number());
            first ? out_.move_to(point) : out_.line_to(point);
            if (first && closed) out_.close();
        }
    }

    pugi::xml_node element_;
    Affine map_;
    SvgViewport viewport_;
    Flattener out_;
    SvgFigure figure_;
};

}  // namespace

bool is_figure(std::string_view tag) {
    static constexpr std::array<std::string_view, 7> kTags{"circle",  "ellipse",  "line", "path",
                                                           "polygon", "polyline", "rect"};
    return std::ranges::find(kTags, tag) != kTags.end();
}

SvgFigure read_figure(const pugi::xml_node& element, const Affine& world_from_element, const SvgViewport& viewport,
                      double tolerance) {
    return FigureReader(element, world_from_element, viewport, tolerance).run();
}

}  // namespace tumble::scene
