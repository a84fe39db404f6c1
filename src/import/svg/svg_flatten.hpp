// Divides curves into chords.
#pragma once

#include <cstddef>
#include <vector>

#include "import/svg/svg_transform.hpp"
#include "tumble/math.hpp"

namespace tumble::scene {

// A polyline in world coordinates, m. If it is closed, the last point differs from the first.
struct Contour {
    std::vector<DVec2> points;
    bool closed = false;
};

// centre + cos t x_axis + sin t y_axis, from t = start to start + turn (radians).
struct EllipseArc {
    DVec2 center;
    DVec2 x_axis;
    DVec2 y_axis;
    double start = 0.0;
    double turn = 0.0;
};

// Takes lines and curves in the coordinates of an element and makes contours in the world. No point of a curve is
// farther than `tolerance` (m) from its chord.
class Flattener {
public:
    Flattener(const Affine& world_from_element, double tolerance) : map_(world_from_element), tolerance_(tolerance) {}

    void move_to(DVec2 point);
    void line_to(DVec2 point);
    void quadratic_to(DVec2 control, DVec2 point);
    void cubic_to(DVec2 control, DVec2 other_control, DVec2 point);
    void arc_to(const EllipseArc& arc, DVec2 point);  // `point` is the arc's end, exactly
    void close();

    // Returns the contours without coinciding points and without contours of a single point. A contour that ends where
    // it began is closed. The functions above throw SvgError for points that are not finite or farther than 100 km from
    // the origin, and for more points than a shape may have.
    std::vector<Contour> take();

private:
    void add(DVec2 world_point);
    std::size_t chord_count(double chords) const;

    Affine map_;
    double tolerance_;
    std::size_t count_ = 0;
    std::vector<Contour> contours_;
};

}  // namespace tumble::scene
