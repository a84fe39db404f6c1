#include "render/frame/joint_paths.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::render {
namespace {

constexpr double kStraightEnds = 0.12;  // of a coil, each, over its length
constexpr double kPitch = 1.4;          // of a coil at rest, over its half width
constexpr double kFewestTurns = 4.0, kMostTurns = 20.0;
constexpr double kWidthOverLength = 0.12;  // largest half width of a coil over its length at rest
constexpr int kRopeParts = 24;             // lines of a slack rope
constexpr double kSlack = 1e-3;            // share of its length by which a rope is slack before it sags
constexpr int kArcParts = 16;              // lines of an arc of rope on a wheel

DVec2 left_of(DVec2 direction) { return {-direction.y, direction.x}; }

// A wheel that a rope runs around, or an end of the rope.
struct Round {
    DVec2 center;
    double offset = 0.0;  // of the rope to the left of the centre, seen along the rope
};

struct Tangent {
    DVec2 from, to;  // where the straight part of the rope leaves the one and reaches the other
};

// The line n x = c with the left normal n has n center + offset = c at both, so that n d = from.offset - to.offset.
Tangent tangent_of(const Round& from, const Round& to) {
    const DVec2 d = to.center - from.center;
    const double distance = length(d);
    if (!(distance > std::abs(from.offset - to.offset))) return {from.center, to.center};
    const double sine = (from.offset - to.offset) / distance;
    const DVec2 along = (1.0 / distance) * d;
    const DVec2 normal = sine * along + std::sqrt(1.0 - sine * sine) * left_of(along);
    return {from.center + from.offset * normal, to.center + to.offset * normal};
}

// 1 if the path turns right at the corner, so that a wheel inside the turn has the rope on its left, else -1.
double side_of_turn(DVec2 from, DVec2 corner, DVec2 to) {
    return dot(left_of(corner - from), to - corner) > 0.0 ? -1.0 : 1.0;
}

// The rope around the wheel from one of its points to another, clockwise if the rope is on its left.
void add_arc(std::vector<DVec2>& points, const Round& wheel, DVec2 from, DVec2 to) {
    const DVec2 begin = from - wheel.center, end = to - wheel.center;
    const double turn = wheel.offset > 0.0 ? -1.0 : 1.0;
    double angle = turn * std::atan2(dot(left_of(begin), end), dot(begin, end));
    // Rounding can make a rope that only touches the wheel go once around it.
    if (angle < -1e-6) angle += 2.0 * kPi;
    for (int i = 0; i <= kArcParts; ++i) {
        const double a = turn * angle * i / kArcParts;
        points.push_back(wheel.center + std::cos(a) * begin + std::sin(a) * left_of(begin));
    }
}

}  // namespace

std::vector<DVec2> coil_path(DVec2 a, DVec2 b, double rest_length, double half_width) {
    const double distance = length(b - a);
    if (!(distance > 0.0) || !(rest_length > 0.0)) return {a, b};
    const double width = std::min(half_width, kWidthOverLength * rest_length);
    const double turns = std::clamp(std::round(rest_length / (kPitch * width)), kFewestTurns, kMostTurns);
    const DVec2 along = b - a, side = (width / distance) * left_of(along);
    std::vector<DVec2> path{a, a + kStraightEnds * along};
    const int corners = 2 * static_cast<int>(turns);
    for (int i = 0; i < corners; ++i) {
        const double share = kStraightEnds + (1.0 - 2.0 * kStraightEnds) * (i + 0.5) / corners;
        path.push_back(a + share * along + (i % 2 == 0 ? 1.0 : -1.0) * side);
    }
    path.push_back(b - kStraightEnds * along);
    path.push_back(b);
    return path;
}

std::vector<DVec2> rope_path(DVec2 a, DVec2 b, double rope_length, DVec2 down) {
    const double distance = length(b - a), fall = length(down);
    if (!(fall > 0.0) || rope_length <= (1.0 + kSlack) * distance) return {a, b};
    // A shallow parabola of sag s over the distance d has the length d + 8 s^2 / (3 d); a deep one about twice its sag.
    const double slack = rope_length - distance;
    const double sag = std::min(std::sqrt(0.375 * distance * slack), 0.5 * rope_length);
    std::vector<DVec2> path;
    for (int i = 0; i <= kRopeParts; ++i) {
        const double t = static_cast<double>(i) / kRopeParts;
        path.push_back(a + t * (b - a) + (4.0 * t * (1.0 - t) * sag / fall) * down);
    }
    return path;
}

PulleyPath pulley_path(DVec2 a, DVec2 ground_a, DVec2 ground_b, DVec2 b, double radius, DVec2 down) {
    PulleyPath path{{}, ground_a, ground_b, 0.0};
    path.radius = std::min(radius, length(ground_b - ground_a) / 3.0);
    if (length(down) > 0.0) {
        const DVec2 level = (1.0 / length(down)) * left_of(down);
        const double shift = std::copysign(path.radius, dot(level, ground_b - ground_a));
        path.wheel_a = ground_a + shift * level;
        path.wheel_b = ground_b - shift * level;
    }
    const double side_a = side_of_turn(a, ground_a, ground_b), side_b = side_of_turn(ground_a, ground_b, b);
    const Round from{path.wheel_a, side_a * path.radius}, to{path.wheel_b, side_b * path.radius};
    const Tangent first = tangent_of({a, 0.0}, from), middle = tangent_of(from, to), last = tangent_of(to, {b, 0.0});
    path.points.push_back(first.from);
    add_arc(path.points, from, first.to, middle.from);
    add_arc(path.points, to, middle.to, last.from);
    path.points.push_back(last.to);
    return path;
}

}  // namespace tumble::render
