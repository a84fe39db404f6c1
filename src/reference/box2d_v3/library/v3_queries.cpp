// Queries of Box2D v3.
#include <box2d/box2d.h>
#include <box2d/constants.h>

#include <cstddef>
#include <string>
#include <vector>

#include "reference/box2d_v3/library/v3_library.hpp"

namespace tumble::box2d_v3 {

namespace {

b2ShapeProxy proxy_of(const Points& points) {
    b2Vec2 at[kMostPoints];
    for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i)
        at[i] = {points.xy[2 * i], points.xy[2 * i + 1]};
    return b2MakeProxy(at, points.count, points.radius);
}

b2Transform transform_of(const Place& place) { return {{place.x, place.y}, {place.c, place.s}}; }

b2Sweep sweep_of(const Motion& motion) {
    return {{motion.center_x, motion.center_y},
            {motion.from.x, motion.from.y},
            {motion.to.x, motion.to.y},
            {motion.from.c, motion.from.s},
            {motion.to.c, motion.to.s}};
}

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

struct Pairs {
    struct Pair {
        b2DistanceInput input;
        b2Transform pose_a, pose_b;
        b2SimplexCache cache{};
    };
    std::vector<Pair> all{};
};

Pairs* make_pairs() { return new Pairs; }
void destroy(Pairs* pairs) { delete pairs; }

void add(Pairs* pairs, const Points& a, const Place& pose_a, const Points& b, const Place& pose_b) {
    pairs->all.push_back({{proxy_of(a), proxy_of(b), {}, true}, transform_of(pose_a), transform_of(pose_b)});
}

double run(Pairs* pairs, bool is_warm) {
    double sum = 0.0;
    for (Pairs::Pair& pair : pairs->all) {
        pair.input.transform = b2InvMulTransforms(pair.pose_a, pair.pose_b);
        if (!is_warm) pair.cache = {};
        sum += double{b2ShapeDistance(&pair.input, &pair.cache, nullptr, 0).distance};
    }
    return sum;
}

Hit cast_shape(const Points& a, const Points& b, const Place& b_in_a, float x, float y) {
    const b2ShapeCastPairInput input{proxy_of(a), proxy_of(b), transform_of(b_in_a), {x, y}, 1.0f, false};
    return hit_of(b2ShapeCast(&input));
}

Hit cast_ray(const Points& shape, float origin_x, float origin_y, float x, float y) {
    const b2RayCastInput input{{origin_x, origin_y}, {x, y}, 1.0f};
    if (shape.count == 1) {
        const b2Circle circle{{shape.xy[0], shape.xy[1]}, shape.radius};
        return hit_of(b2RayCastCircle(&circle, &input));
    }
    b2Vec2 at[kMostPoints];
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape.count); ++i)
        at[i] = {shape.xy[2 * i], shape.xy[2 * i + 1]};
    const b2Hull hull = b2ComputeHull(at, shape.count);
    const b2Polygon polygon = b2MakePolygon(&hull, shape.radius);
    return hit_of(b2RayCastPolygon(&polygon, &input));
}

Hit time_of_impact(const Points& a, const Points& b, const Motion& of_a, const Motion& of_b) {
    const b2TOIInput input{proxy_of(a), proxy_of(b), sweep_of(of_a), sweep_of(of_b), 1.0f};
    const b2TOIOutput output = b2TimeOfImpact(&input);
    return {output.state == b2_toiStateHit, output.state == b2_toiStateOverlapped, output.fraction};
}

float linear_slop() { return B2_LINEAR_SLOP; }

}  // namespace tumble::box2d_v3
