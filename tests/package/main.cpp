// Uses each library once: exit code 0 if the answers are right.
#include <cmath>
#include <cstdio>

#include "tumble/distance.hpp"
#include "tumble/instruction_set.hpp"
#include "tumble/render.hpp"

extern "C" double tumble_plugin_height();

int main() {
    const tumble::Shape circle = tumble::make_circle(1.0f);
    const tumble::DistanceResult gap = tumble::distance(circle, {}, circle, {{3.0, 0.0}, {}});
    tumble::write_png({.width = 1, .height = 1, .rgba = {255, 0, 0, 255}}, "pixel.png");
    std::printf("%s: distance %.17g, height %.3f\n", tumble::instruction_set().c_str(), gap.distance,
                tumble_plugin_height());
    return gap.distance == 1.0 && std::abs(tumble_plugin_height() - 1.0) < 0.01 ? 0 : 1;
}
