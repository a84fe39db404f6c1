#include "reference/exact/exact_geometry.hpp"

#include <algorithm>
#include <span>

#include "debug/check.hpp"
#include "reference/exact/support_follower.hpp"

namespace tumble::reference {

namespace {

// These use the C interface of GMP, in which the target keeps its memory: twice as fast as expressions that allocate.
void set_dot(mpz_class& target, const ExactPoint& p, const ExactPoint& q) {
    mpz_mul(target.get_mpz_t(), p.x.get_mpz_t(), q.x.get_mpz_t());
    mpz_addmul(target.get_mpz_t(), p.y.get_mpz_t(), q.y.get_mpz_t());
}

void set_cross(mpz_class& target, const ExactPoint& p, const ExactPoint& q) {
    mpz_mul(target.get_mpz_t(), p.x.get_mpz_t(), q.y.get_mpz_t());
    mpz_submul(target.get_mpz_t(), p.y.get_mpz_t(), q.x.get_mpz_t());
}

int lowest_bit_exponent(std::span<const float> values, int lowest = kZeroExponent) {
    for (const float value : values) lowest = std::min(lowest, reference::lowest_bit_exponent(double{value}));
    return lowest;
}

// The exponents of the units in which a shape's rotation and vertices are integers.
struct ShapeUnits {
    int rotation = 0;
    int vertex = 0;

    ShapeUnits(const Shape& shape, Rotation q) {
        rotation = std::min(reference::lowest_bit_exponent(double{q.c}), reference::lowest_bit_exponent(double{q.s}));
        vertex = lowest_bit_exponent(shape.y(), lowest_bit_exponent(shape.x()));
    }

    // Of the products of both; about kZeroExponent if all of them are zero (vanishes()).
    int product() const { return std::min(kZeroExponent, rotation + vertex); }
    bool vanishes() const { return rotation == kZeroExponent || vertex == kZeroExponent; }
};

std::vector<ExactPoint> rotated_vertices(const Shape& shape, Rotation q, const ShapeUnits& units, int exponent,
                                         const ExactPoint& offset) {
    std::vector<ExactPoint> points(static_cast<std::size_t>(shape.vertex_count()), offset);
    if (units.vanishes()) return points;
    const mpz_class c = scaled(q.c, units.rotation), s = scaled(q.s, units.rotation);
    TUMBLE_CHECK(exponent <= units.product());
    const auto shift = static_cast<mp_bitcnt_t>(units.product() - exponent);
    mpz_class x, y, rotated;
    for (std::size_t i = 0; i < points.size(); ++i) {
        x = scaled(shape.x()[i], units.vertex);
        y = scaled(shape.y()[i], units.vertex);
        rotated = c * x - s * y;
        points[i].x += rotated << shift;
        rotated = s * x + c * y;
        points[i].y += rotated << shift;
    }
    return points;
}

using ExactFollower = MinkowskiFollower<ExactPoint, mpz_class, set_dot>;

SignedRoot root_of(const mpz_class& value, const mpz_class& divisor_sq, int exponent) {
    return {sgn(value), value * value, divisor_sq, exponent};
}

// The faces with the normals of one outline's edges.
void add_faces(const ExactPair& pair, bool is_of_a, SignedRoot& deepest, bool& found) {
    const std::size_t count = is_of_a ? pair.a.size() : pair.b.size();
    ExactFollower follower(pair.a, pair.b);
    mpz_class length_sq;
    for (std::size_t i = 0; i < count; ++i) {
        const ExactPoint normal = face_normal(pair, is_of_a, i);
        if (is_zero(normal)) continue;
        set_dot(length_sq, normal, normal);
        const mpz_class minus_h = -follower.support_value(normal);
        SignedRoot face = root_of(minus_h, length_sq, pair.exponent);
        if (!found || compare(face, deepest) > 0) deepest = std::move(face);
        found = true;
    }
}

}  // namespace

ExactPoint operator-(const ExactPoint& p, const ExactPoint& q) { return {p.x - q.x, p.y - q.y}; }

bool is_zero(const ExactPoint& p) { return p.x == 0 && p.y == 0; }

ExactPair exact_pair(const PairQuery& query) {
    const DVec2 pa = query.pose_a.position, pb = query.pose_b.position;
    const ShapeUnits units_a(query.a, query.pose_a.rotation), units_b(query.b, query.pose_b.rotation);
    int exponent = std::min(units_a.product(), units_b.product());
    for (const double value : {pa.x, pa.y, pb.x, pb.y}) exponent = std::min(exponent, lowest_bit_exponent(value));
    if (exponent == kZeroExponent) exponent = 0;
    const ExactPoint offset{scaled(pb.x, exponent) - scaled(pa.x, exponent),
                            scaled(pb.y, exponent) - scaled(pa.y, exponent)};
    return {rotated_vertices(query.a, query.pose_a.rotation, units_a, exponent, {}),
            rotated_vertices(query.b, query.pose_b.rotation, units_b, exponent, offset), exponent};
}

ExactPoint minkowski_vertex(const ExactPair& pair, VertexPair indices) {
    TUMBLE_CHECK(indices.a < pair.a.size());
    TUMBLE_CHECK(indices.b < pair.b.size());
    return pair.a[indices.a] - pair.b[indices.b];
}

mpz_class support_value(const ExactPair& pair, const ExactPoint& direction) {
    return ExactFollower(pair.a, pair.b).support_value(direction);
}

SignedRoot separation(const ExactPair& pair, const ExactPoint& direction) {
    mpz_class length_sq;
    set_dot(length_sq, direction, direction);
    TUMBLE_CHECK(sgn(length_sq) > 0);
    return root_of(-support_value(pair, direction), length_sq, pair.exponent);
}

const SignedRoot& SegmentMeter::measure(const ExactPoint& from, const ExactPoint& to) {
    set_difference(edge_, to, from);
    set_dot(along_, from, edge_);
    along_ = -along_;
    set_dot(root_.denominator, edge_, edge_);
    if (along_ > 0 && along_ < root_.denominator) {
        set_cross(root_.numerator, from, to);
        root_.numerator *= root_.numerator;
    } else {
        const ExactPoint& end = along_ <= 0 ? from : to;
        set_dot(root_.numerator, end, end);
        root_.denominator = 1;
    }
    root_.sign = sgn(root_.numerator);
    return root_;
}

SignedRoot segment_distance(const ExactPair& pair, const ExactPoint& from, const ExactPoint& to) {
    return SegmentMeter(pair).measure(from, to);
}

void set_difference(ExactPoint& target, const ExactPoint& p, const ExactPoint& q) {
    mpz_sub(target.x.get_mpz_t(), p.x.get_mpz_t(), q.x.get_mpz_t());
    mpz_sub(target.y.get_mpz_t(), p.y.get_mpz_t(), q.y.get_mpz_t());
}

ExactPoint exact_direction(DVec2 direction) {
    const int exponent = std::min(lowest_bit_exponent(direction.x), lowest_bit_exponent(direction.y));
    return {scaled(direction.x, exponent), scaled(direction.y, exponent)};
}

SignedRoot claimed_face_separation(const ExactPair& pair, const ExactPoint& w1, const ExactPoint& w2,
                                   const ExactPoint& direction) {
    const ExactPoint edge = w2 - w1;
    if (is_zero(edge)) {
        SignedRoot distance = segment_distance(pair, w1, w2);
        distance.sign = -distance.sign;
        return distance;
    }
    const mpz_class along = direction.x * edge.y - direction.y * edge.x;  // direction . (edge.y, -edge.x)
    const int side = along < 0 ? -1 : 1;
    const mpz_class value = side * (w1.y * edge.x - w1.x * edge.y);
    return {sgn(value), value * value, edge.x * edge.x + edge.y * edge.y, pair.exponent};
}

ExactPoint face_normal(const ExactPair& pair, bool is_of_a, std::size_t edge) {
    const std::vector<ExactPoint>& outline = is_of_a ? pair.a : pair.b;
    const ExactPoint along = outline[edge + 1 == outline.size() ? 0 : edge + 1] - outline[edge];
    return is_of_a ? ExactPoint{along.y, -along.x} : ExactPoint{-along.y, along.x};
}

bool find_deepest_face(const ExactPair& pair, SignedRoot& deepest) {
    bool found = false;
    add_faces(pair, true, deepest, found);
    add_faces(pair, false, deepest, found);
    return found;
}

}  // namespace tumble::reference
