// The body's origin is the middle of the figure's bounding box, so that shape coordinates, which are float, stay exact
// far from the world's origin.
#include "import/svg/svg_body.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "import/svg/svg_holes.hpp"
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

// A contour among those of a figure.
struct Boundary {
    const Contour* contour;
    int depth = 0;    // the number of contours around it
    int outside = 0;  // the winding number just outside of it
    int inside = 0;
};

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
            add_areas(areas);
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

    bool is_filled(int winding) const { return style_.even_odd ? winding % 2 != 0 : winding != 0; }

    // One point of a contour decides what is around it.
    std::vector<Boundary> boundaries_of(const std::vector<const Contour*>& areas) const {
        std::vector<Boundary> result;
        for (const Contour* area : areas) {
            Boundary& boundary = result.emplace_back(Boundary{area});
            for (const Contour* other : areas) {
                const int around = other == area ? 0 : winding_number(other->points, area->points.front());
                boundary.depth += around != 0 ? 1 : 0;
                boundary.outside += around;
            }
            boundary.inside = boundary.outside + (twice_area_of(area->points) > 0.0 ? 1 : -1);
        }
        return result;
    }

    // Each contour bounds an area from outside, or a hole in the innermost area around it, or neither: then it is
    // inside an area to which it belongs.
    void add_areas(const std::vector<const Contour*>& areas) {
        const std::vector<Boundary> boundaries = boundaries_of(areas);
        std::map<const Boundary*, std::vector<const Contour*>> holes;
        for (const Boundary& boundary : boundaries) {
            const bool fills_outside = is_filled(boundary.outside), fills_inside = is_filled(boundary.inside);
            if (fills_outside && fills_inside) ++notes_["areas within areas, which are joined"];
            if (fills_outside || !fills_inside) continue;
            holes[&boundary];
        }
        for (const Boundary& boundary : boundaries) {
            if (!is_filled(boundary.outside) || is_filled(boundary.inside)) continue;
            const Boundary* innermost = nullptr;
            for (const auto& [outer, unused] : holes)
                if (winding_number(outer->contour->points, boundary.contour->points.front()) != 0 &&
                    (innermost == nullptr || outer->depth > innermost->depth))
                    innermost = outer;
            if (innermost != nullptr) holes[innermost].push_back(boundary.contour);
        }
        for (const Boundary& boundary : boundaries)
            if (const auto found = holes.find(&boundary); found != holes.end())
                add_area(*boundary.contour, found->second);
    }

    void add_area(const Contour& area, const std::vector<const Contour*>& holes) {
        if (holes.empty()) return add_outline(local_points(area));
        std::vector<Ring> rings;
        for (const Contour* hole : holes) rings.push_back(ring_of(*hole, -1.0));
        const std::optional<std::vector<Ring>> pieces = cut_open(ring_of(area, 1.0), rings);
        const auto is_simple = [](const Ring& piece) {
            try {
                make_shapes(OutlineGeometry{piece});
                return true;
            } catch (const std::invalid_argument&) {
                return false;
            }
        };
        if (!pieces || !std::ranges::all_of(*pieces, is_simple)) {
            notes_["holes that cannot be cut open, which are filled in"] += static_cast<int>(holes.size());
            return add_outline(local_points(area));
        }
        for (const Ring& piece : *pieces) add_outline(piece);
    }

    // The local points of a contour, rounded to float, without repetitions; counter-clockwise for the sign 1, clockwise
    // for -1.
    Ring ring_of(const Contour& contour, double sign) const {
        Ring ring;
        for (const DVec2 point : local_points(contour)) {
            const DVec2 rounded(to_float(point));
            if (ring.empty() || ring.back() != rounded) ring.push_back(rounded);
        }
        while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
        if (sign * twice_area_of(ring) < 0.0) std::ranges::reverse(ring);
        return ring;
    }

    void add_outline(const std::vector<DVec2>& points) {
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
