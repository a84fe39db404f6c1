// The lines of springs, ropes and pulleys. Points and lengths in pixels, y up.
#pragma once

#include <vector>

#include "tumble/math.hpp"

namespace tumble::render {

// A zigzag from a to b between two straight ends. The number of turns follows from the length at rest, so that it stays
// while the spring is stretched. `half_width` is the largest distance of the turns from the axis.
std::vector<DVec2> coil_path(DVec2 a, DVec2 b, double rest_length, double half_width);

// A rope of the given length between two points: a straight line, or a parabola of about that length in the direction
// `down` if it is slack.
std::vector<DVec2> rope_path(DVec2 a, DVec2 b, double rope_length, DVec2 down);

struct PulleyPath {
    std::vector<DVec2> points;  // from a over both wheels to b
    DVec2 wheel_a, wheel_b;     // centres
    double radius = 0.0;        // of both
};

// The rope goes around both wheels, each inside the turn of the rope at its ground anchor. With gravity, `down`, the
// wheels are beside the ground anchors, so that a rope that hangs down leaves its wheel there; else they are at the
// ground anchors. The radius is at most `radius` and a third of the distance of the ground anchors.
PulleyPath pulley_path(DVec2 a, DVec2 ground_a, DVec2 ground_b, DVec2 b, double radius, DVec2 down);

}  // namespace tumble::render
