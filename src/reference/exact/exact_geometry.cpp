#include "reference/exact/exact_geometry.hpp"

#include <algorithm>
#include <span>

#include "debug/check.hpp"
namespace tumble::reference {

namespace {

// An outline of at most this many vertices is searched; in a larger one the support vertex is followed.
constexpr std::size_t kSearchAll = 64;

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

// Support values of one outline for a sequence of directions that turns counter-clockwise.
class SupportFollower {
public:
    explicit SupportFollower(const std::vector<ExactPoint>& vertices) : vertices_(vertices) {}

    const mpz_class& maximum(const ExactPoint& direction) {
        if (vertices_.size() <= kSearchAll || !started_) {
            search_all(direction);
        } else {
            follow(direction);
        }
        started_ = true;
        return value_;
    }

private:
    void search_all(const ExactPoint& direction) {
        set_dot(value_, vertices_[0], direction);
        index_ = 0;
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            set_dot(next_value_, vertices_[i], direction);
            if (next_value_ > value_) {
                swap(value_, next_value_);
                index_ = i;
            }
        }
    }

    void follow(const ExactPoint& direction) {
        set_dot(value_, vertices_[index_], direction);
        for (std::size_t step = 0; step < vertices_.size(); ++step) {
            const std::size_t next = index_ + 1 == vertices_.size() ? 0 : index_ + 1;
            set_dot(next_value_, vertices_[next], direction);
            if (next_value_ < value_) return;
            swap(value_, next_value_);
            index_ = next;
        }
    }

    const std::vector<ExactPoint>& vertices_;
    mpz_class value_, next_value_;
    std::size_t index_ = 0;
    bool started_ = false;
};

// h for directions that turn counter-clockwise: max direction . a + max (-direction) . b.
class MinkowskiFollower {
public:
    explicit MinkowskiFollower(const ExactPair& pair) : a_(pair.a), b_(pair.b) {}

    mpz_class support_value(const ExactPoint& direction) {
        opposite_.x = -direction.x;
        opposite_.y = -direction.y;
        return a_.maximum(direction) + b_.maximum(opposite_);
    }

private:
    SupportFollower a_, b_;
    ExactPoint opposite_;
};

SignedRoot root_of(const mpz_class& value, const mpz_class& divisor_sq, int exponent) {
    return {sgn(value), value * value, divisor_sq, exponent};
}

// The faces with the normals of one outline's edges: outward for A, inward for B, since B enters negated.
void add_faces(const ExactPair& pair, const std::vector<ExactPoint>& outline, int side, SignedRoot& deepest,
               bool& found, bool stop_if_separated) {
    MinkowskiFollower follower(pair);
    ExactPoint edge, normal;
    mpz_class length_sq;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        edge = outline[i + 1 == outline.size() ? 0 : i + 1] - outline[i];
        if (is_zero(edge)) continue;
        normal.x = side * edge.y;
        normal.y = -side * edge.x;
        set_dot(length_sq, edge, edge);
        const mpz_class minus_h = -follower.support_value(normal);
        SignedRoot face = root_of(minus_h, length_sq, pair.exponent);
        if (!found || compare(face, deepest) > 0) deepest = std::move(face);
        found = true;
        if (stop_if_separated && deepest.sign > 0) return;
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
    return MinkowskiFollower(pair).support_value(direction);
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

bool find_deepest_face(const ExactPair& pair, SignedRoot& deepest, bool stop_if_separated) {
    bool found = false;
    add_faces(pair, pair.a, 1, deepest, found, stop_if_separated);
    if (found && stop_if_separated && deepest.sign > 0) return true;
    add_faces(pair, pair.b, -1, deepest, found, stop_if_separated);
    return found;
}

}  // namespace tumble::reference
