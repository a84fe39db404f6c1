#include "reference/families/cast_families.hpp"

#include <algorithm>
#include <array>

#include "reference/box2d/b2_cast.hpp"
#include "reference/query/random_shapes.hpp"

namespace tumble::reference {

namespace {

// Positions and angles are floats: Box2D gets exactly the same bodies, and no error comes from the conversion.
DVec2 as_float(DVec2 v) { return DVec2(to_float(v)); }
double as_float(double angle) { return static_cast<float>(angle); }

// Near the origin, and one in five 10 km away.
DVec2 somewhere(Random& random) { return random.point(random.chance(0.2) ? 1e4 : 1.0); }

Shape about_a_metre(Random& random) { return random_shape(random, random.integer(-1, 1)); }
Shape bare(const Shape& shape) { return PairQuery{shape, shape, {}, {}}.without_radii().a; }

// From a few metres away towards a point near `target`; the translation ends before, at or beyond that point.
struct Motion {
    DVec2 from, translation;
};
Motion random_motion(Random& random, DVec2 target) {
    const DVec2 from = as_float(target + random.point(5.0)), aim = target + random.point(1.2);
    return {from, as_float(random.uniform(0.2, 3.0) * (aim - from))};
}

CastQuery ray(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    CastQuery query;
    query.a = about_a_metre(random);
    query.b = make_circle(0);
    query.pose_a.position = as_float(somewhere(random));
    query.pose_a.rotation = random.rotation();
    const Motion motion = random_motion(random, query.pose_a.position);
    query.pose_b.position = motion.from;
    query.translation = motion.translation;
    return query;
}

CastQuery shape_cast(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    CastQuery query = ray(seed, random.bits());
    query.kind = CastKind::shape;
    query.b = about_a_metre(random);
    query.pose_b.rotation = random.rotation();
    // Half of them as Box2D casts shapes: bare cores, to the distance at which it stops.
    if (random.chance(0.5)) {
        query.a = bare(query.a);
        query.b = bare(query.b);
        query.target = b2_target(CastKind::shape);
    } else if (random.chance(0.3)) {
        query.target = random.uniform(0.0, 0.3);
    }
    return query;
}

Sweep sweep_of(Random& random, DVec2 from, DVec2 displacement, double turn) {
    const Vec2 center = to_float(random.point(0.3));
    const double start_angle = as_float(random.uniform(-4.0, 4.0)), turned = as_float(random.uniform(-turn, turn));
    // The end angle of Box2D is a float too.
    return {center, from, as_float(from + displacement), start_angle,
            random.chance(0.2) ? 0.0 : as_float(start_angle + turned) - start_angle};
}

CastQuery impact(std::uint64_t seed, std::uint64_t index, double turn) {
    Random random(seed, index);
    CastQuery query = shape_cast(seed, random.bits());
    query.kind = CastKind::impact;
    if (query.target == b2_target(CastKind::shape)) query.target = b2_target(CastKind::impact);
    query.sweep_a = sweep_of(random, query.pose_a.position, as_float(random.point(0.5)), turn);
    query.sweep_b = sweep_of(random, query.pose_b.position, query.translation, turn);
    return query;
}

CastQuery straight_impact(std::uint64_t seed, std::uint64_t index) {
    CastQuery query = impact(seed, index, 0.0);
    query.sweep_a.turn = query.sweep_b.turn = 0.0;
    return query;
}

CastQuery turning_impact(std::uint64_t seed, std::uint64_t index) { return impact(seed, index, 1.5); }
CastQuery spinning_impact(std::uint64_t seed, std::uint64_t index) { return impact(seed, index, 12.0); }

// The oracle takes about 50 us for a moving pair, hence the small shares.
constexpr std::array kFamilies = {
    CastFamily{"rays", "rays at shapes of every kind from a few metres away, near the origin and 10 km from it", ray,
               0.25},
    CastFamily{"shape_casts", "linear casts of every pair of kinds, half of them as Box2D casts them", shape_cast,
               0.15},
    CastFamily{"toi_translation", "times of impact of bodies that do not turn", straight_impact, 0.15},
    CastFamily{"toi_rotation", "times of impact of bodies that turn by up to a quarter of a turn", turning_impact, 0.1},
    CastFamily{"toi_spin", "times of impact of bodies that turn by up to two turns", spinning_impact, 0.05},
};

}  // namespace

std::span<const CastFamily> cast_families() { return kFamilies; }

const CastFamily* find_cast_family(std::string_view name) {
    const auto found = std::ranges::find(kFamilies, name, &CastFamily::name);
    return found == kFamilies.end() ? nullptr : &*found;
}

}  // namespace tumble::reference
