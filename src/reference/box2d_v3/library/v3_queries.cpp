// Queries of Box2D v3.
#include <box2d/box2d.h>
#include <box2d/constants.h>

#include <string>

#include "reference/box2d_v3/library/v3_library.hpp"
#include "reference/box2d_v3/library/v3_types.hpp"

namespace tumble::box2d_v3 {

namespace {

Hit hit_of(const b2CastOutput& output) { return {output.hit, false, output.hit ? output.fraction : 1.0f}; }

}  // namespace

const char* version() {
    static const std::string text = [] {
        const b2Version number = b2GetVersion();
        return std::to_string(number.major) + "." + std::to_string(number.minor) + "." +
               std::to_string(number.revision);
    }();
    return text.c_str();
}

Nearest distance(const Points& a, const Points& b, const Place& b_in_a, bool use_radii) {
    const b2DistanceInput input{proxy_of(a), proxy_of(b), transform_of(b_in_a), use_radii};
    b2SimplexCache cold{};
    const b2DistanceOutput found = b2ShapeDistance(&input, &cold, nullptr, 0);
    return {found.distance, found.pointA.x, found.pointA.y, found.pointB.x, found.pointB.y, found.iterations};
}

Hit cast_shape(const Points& a, const Points& b, const Place& b_in_a, float x, float y) {
    const b2ShapeCastPairInput input{proxy_of(a), proxy_of(b), transform_of(b_in_a), {x, y}, 1.0f, false};
    return hit_of(b2ShapeCast(&input));
}

Hit cast_ray(const Points& shape, float origin_x, float origin_y, float x, float y) {
    const b2RayCastInput input{{origin_x, origin_y}, {x, y}, 1.0f};
    if (shape.count == 1) {
        const b2Circle circle = circle_of(shape);
        return hit_of(b2RayCastCircle(&circle, &input));
    }
    const b2Polygon polygon = polygon_of(shape);
    return hit_of(b2RayCastPolygon(&polygon, &input));
}

Hit time_of_impact(const Points& a, const Points& b, const Motion& of_a, const Motion& of_b) {
    const b2TOIInput input{proxy_of(a), proxy_of(b), sweep_of(of_a), sweep_of(of_b), 1.0f};
    const b2TOIOutput output = b2TimeOfImpact(&input);
    return {output.state == b2_toiStateHit, output.state == b2_toiStateOverlapped, output.fraction};
}

float linear_slop() { return B2_LINEAR_SLOP; }

}  // namespace tumble::box2d_v3
