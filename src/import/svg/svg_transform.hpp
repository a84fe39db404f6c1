// Affine maps of the plane, and the transform attribute of SVG.
#pragma once

#include <string_view>

#include "tumble/math.hpp"

namespace tumble::scene {

// point -> x axis * point.x + y axis * point.y + origin.
struct Affine {
    DVec2 x_axis{1.0, 0.0};
    DVec2 y_axis{0.0, 1.0};
    DVec2 origin;
};

inline DVec2 apply_linear(const Affine& map, DVec2 v) { return v.x * map.x_axis + v.y * map.y_axis; }
inline DVec2 apply(const Affine& map, DVec2 point) { return apply_linear(map, point) + map.origin; }

// The map that applies `inner`, then `outer`.
inline Affine compose(const Affine& outer, const Affine& inner) {
    return {apply_linear(outer, inner.x_axis), apply_linear(outer, inner.y_axis), apply(outer, inner.origin)};
}

// True if the map keeps angles up to their sign, so that circles stay circles and boxes boxes. Allows for the rounding
// of a few composed maps.
bool is_similarity(const Affine& map);

// The value of a transform attribute, its functions applied from right to left. Throws SvgError.
Affine parse_transform(std::string_view text);

}  // namespace tumble::scene
