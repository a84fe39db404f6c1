// Smooth curves (S, T) mirror the last control point if the command before was a curve of the same kind.
#include "import/svg/svg_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "import/svg/svg_text.hpp"

namespace tumble::scene {

namespace {

class PathReader {
public:
    PathReader(std::string_view data, Flattener& out) : scanner_(data), out_(out) {}

    void run() {
        while (!scanner_.at_end()) {
            const char command = scanner_.peek();
            if (std::string_view("MmZzLlHhVvCcSsQqTtAa").find(command) == std::string_view::npos)
                scanner_.refuse("a path command");
            if (previous_ == '\0' && to_lower(command) != 'm') scanner_.refuse("'M' or 'm' to begin with");
            scanner_.take();
            run_command(to_lower(command), command != to_lower(command));
        }
    }

private:
    // Runs a command once for each set of arguments that follows.
    void run_command(char command, bool absolute) {
        base_ = absolute ? DVec2{} : current_;
        if (command == 'z') return close();
        do {
            step(command);
            previous_ = command;
            if (command == 'm') command = 'l';
            if (!absolute) base_ = current_;
            scanner_.at_end();
        } while (scanner_.at_number());
    }

    void step(char command) {
        if (command != 'm') begin_contour();
        switch (command) {
            case 'm':
                current_ = start_ = point();
                open_ = false;
                break;
            case 'l': line_to(point()); break;
            case 'h': line_to({base_.x + scanner_.number(), current_.y}); break;
            case 'v': line_to({current_.x, base_.y + scanner_.number()}); break;
            case 'c':
                control_ = point();
                cubic_to(control_);
                break;
            case 's': cubic_to(mirrored('c', 's')); break;
            case 'q': quadratic_to(point()); break;
            case 't': quadratic_to(mirrored('q', 't')); break;
            default: arc_to(); break;
        }
    }

    // A contour begins with its first line: after a move, or at the start of the contour that was closed before.
    void begin_contour() {
        if (!open_) out_.move_to(current_);
        open_ = true;
    }

    void close() {
        if (open_) out_.close();
        open_ = false;
        current_ = start_;
        previous_ = 'z';
    }

    DVec2 point() {
        const double x = scanner_.number();
        return base_ + DVec2(x, scanner_.number());
    }

    DVec2 mirrored(char command, char smooth) const {
        return previous_ == command || previous_ == smooth ? 2.0 * current_ - control_ : current_;
    }

    void line_to(DVec2 end) {
        out_.line_to(end);
        current_ = end;
    }

    void cubic_to(DVec2 first_control) {
        control_ = point();
        const DVec2 end = point();
        out_.cubic_to(first_control, control_, end);
        current_ = end;
    }

    void quadratic_to(DVec2 control) {
        control_ = control;
        const DVec2 end = point();
        out_.quadratic_to(control, end);
        current_ = end;
    }

    void arc_to() {
        const double rx = std::abs(scanner_.number()), ry = std::abs(scanner_.number());
        const double degrees = scanner_.number();
        const bool large = scanner_.flag(), sweep = scanner_.flag();
        const DVec2 end = point();
        if (rx == 0.0 || ry == 0.0 || end == current_)
            out_.line_to(end);
        else
            out_.arc_to(make_arc(current_, end, rx, ry, degrees, large, sweep), end);
        current_ = end;
    }

    SvgScanner scanner_;
    Flattener& out_;
    DVec2 base_;  // origin of the arguments
    DVec2 current_;
    DVec2 start_;    // of the contour
    DVec2 control_;  // the last one
    char previous_ = '\0';
    bool open_ = false;
};

}  // namespace

void read_path(std::string_view data, Flattener& out) { PathReader(data, out).run(); }

// Computed in coordinates in which the ellipse is the unit circle: the centre is on the perpendicular bisector of the
// chord, on the side that the flags select.
EllipseArc make_arc(DVec2 from, DVec2 to, double rx, double ry, double degrees, bool large, bool sweep) {
    const SinCos q = sin_cos_degrees(degrees);
    const DVec2 x_direction(q.cos, q.sin), y_direction(-q.sin, q.cos);
    const DVec2 chord = to - from;
    DVec2 half(0.5 * dot(chord, x_direction) / rx, 0.5 * dot(chord, y_direction) / ry);
    const double reach = length(half);
    const double grow = std::max(reach, 1.0);
    half = (1.0 / grow) * half;
    const double height = std::sqrt(std::max(0.0, 1.0 - length_sq(half)));
    const DVec2 to_center = ((large != sweep ? 1.0 : -1.0) * height / length(half)) * DVec2(-half.y, half.x);
    // From the centre to the ends, on the unit circle.
    const DVec2 start = -half - to_center, end = half - to_center;
    double turn = arc_tangent(cross(start, end), dot(start, end));
    if (sweep && turn < 0.0) turn += 2.0 * kPi;
    if (!sweep && turn > 0.0) turn -= 2.0 * kPi;
    const DVec2 x_axis = (grow * rx) * x_direction, y_axis = (grow * ry) * y_direction;
    const DVec2 offset = to_center + half;
    return {from + offset.x * x_axis + offset.y * y_axis, x_axis, y_axis, arc_tangent(start.y, start.x), turn};
}

}  // namespace tumble::scene
