// The body's origin is the middle of the figure's bounding box, so that shape coordinates, which are float, stay exact
// far from the world's origin.
#include "import/svg/svg_body.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "tumble/outline.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

DVec2 middle_of(const std::vector<Contour>& contours) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    DVec2 lower(infinity, infinity), upper(-infinity, -infinity);
    for (const Contour& contour : contours) {
        for (const DVec2 point : contour.points) {
            lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
            upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
        }
    }
    return 0.5 * (lower + upper);
}

// The number of counter-clockwise turns of the contour around the point.
int winding_number(const Contour& contour, DVec2 point) {
    int turns = 0;
    DVec2 from = contour.points.back();
    for (const DVec2 to : contour.points) {
        const double side = cross(to - from, point - from);
        if (from.y <= point.y && to.y > point.y && side > 0.0) ++turns;
        if (to.y <= point.y && from.y > point.y && side < 0.0) --turns;
        from = to;
    }
    return turns;
}

bool is_counter_clockwise(const Contour& contour) {
    double twice_area = 0.0;
    const DVec2 origin = contour.points.front();
    for (std::size_t i = 1; i + 1 < contour.points.size(); ++i)
        twice_area += cross(contour.points[i] - origin, contour.points[i + 1] - origin);
    return twice_area > 0.0;
}

class BodyMaker {
public:
    BodyMaker(const SvgFigure& figure, const SvgStyle& style, double metres_per_stroke, SvgNotes& notes)
        : figure_(figure), style_(style), stroke_radius_(0.5 * style.stroke_width * metres_per_stroke), notes_(notes) {}

    SceneBody run() {
        body_.position = figure_.exact ? figure_.position : middle_of(figure_.contours);
        std::vector<const Contour*> areas, lines;
        for (const Contour& contour : figure_.contours) (is_area(contour) ? areas : lines).push_back(&contour);
        body_.type = style_.type.value_or(areas.empty() ? BodyType::static_body : BodyType::dynamic_body);
        if (figure_.exact && !areas.empty())
            std::visit([&](const auto& geometry) { add(geometry); }, *figure_.exact);
        else
            for (const Contour* area : areas) add_area(*area, areas);
        for (const Contour* line : lines) add_line(*line);
        return std::move(body_);
    }

private:
    bool is_movable() const { return style_.type && *style_.type != BodyType::static_body; }

    bool is_area(const Contour& contour) const {
        if (contour.points.size() < 3) return false;
        const bool is_filled = style_.fill.visible && (contour.closed || !style_.stroke.visible);
        return is_filled || (contour.closed && is_movable());
    }

    std::vector<DVec2> local_points(const Contour& contour) const {
        std::vector<DVec2> points;
        for (const DVec2 point : contour.points) points.push_back(point - body_.position);
        return points;
    }

    void add(ShapeGeometry geometry) {
        try {
            make_shapes(geometry);
        } catch (const std::invalid_argument&) {
            ++notes_["figures too small for a shape"];
            return;
        }
        body_.shapes.push_back({std::move(geometry), "", ""});
    }

    // One point of the boundary decides whether the area is a hole or lies within another area.
    void add_area(const Contour& area, const std::vector<const Contour*>& areas) {
        int depth = 0, turns = is_counter_clockwise(area) ? 1 : -1;
        for (const Contour* other : areas) {
            if (other == &area) continue;
            const int around = winding_number(*other, area.points.front());
            depth += around != 0 ? 1 : 0;
            turns += around;
        }
        if (depth == 0) return add_outline(area);
        const bool is_hole = style_.even_odd ? depth % 2 == 1 : turns == 0;
        ++notes_[is_hole ? "holes, which are filled in" : "areas within areas, which are joined"];
    }

    void add_outline(const Contour& area) {
        const std::vector<DVec2> points = local_points(area);
        std::vector<Vec2> rounded;
        for (const DVec2 point : points) rounded.push_back(to_float(point));
        try {
            const bool is_convex = decompose_outline(rounded).size() == 1;
            is_convex ? add(PolygonGeometry{points, 0.0}) : add(OutlineGeometry{points});
        } catch (const std::invalid_argument&) {
            if (make_polygon(rounded).vertex_count() > 2)
                ++notes_["outlines that cross themselves, whose hull is taken"];
            add(PolygonGeometry{points, 0.0});
        }
    }

    void add_line(const Contour& line) {
        const std::vector<DVec2> points = local_points(line);
        if (!style_.stroke.visible && !style_.type) {
            ++notes_["hidden elements"];
            return;
        }
        if (!is_movable()) return add(ChainGeometry{points, line.closed, true});
        if (!(stroke_radius_ > 0.0)) {
            ++notes_["moving lines without a width"];
            return;
        }
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            add(CapsuleGeometry{points[i], points[i + 1], stroke_radius_});
    }

    const SvgFigure& figure_;
    const SvgStyle& style_;
    double stroke_radius_;
    SvgNotes& notes_;
    SceneBody body_;
};

}  // namespace

SceneBody make_svg_body(const SvgFigure& figure, const SvgStyle& style, double metres_per_stroke, SvgNotes& notes) {
    return BodyMaker(figure, style, metres_per_stroke, notes).run();
}

}  // namespace tumble::scene
