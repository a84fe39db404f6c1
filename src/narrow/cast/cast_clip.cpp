#include "narrow/cast/cast_clip.hpp"

#include <algorithm>
#include <limits>

#include "debug/check.hpp"
#include "narrow/cast/cast_chain.hpp"
#include "narrow/cast/cast_circle.hpp"
#include "narrow/cores/error_bound.hpp"

namespace tumble {

namespace {

constexpr double kRound = 16.0;  // times E: if the reach is larger, arcs have normals and brackets of their own
constexpr double kNever = std::numeric_limits<double>::infinity();

// A face with the numbers that both its line and its ends need.
struct MeasuredFace {
    ChainFace chain;
    DVec2 normal;  // unit, outwards; zero for a difference that is a point
    double length;
    double rate;  // at which the face closes: -normal . v
};

MeasuredFace measure(const ChainFace& chain, const CastPath& path) {
    const double length_of_edge = length(chain.edge);
    const DVec2 normal = length_of_edge > 0.0 ? (1.0 / length_of_edge) * -perp(chain.edge) : DVec2{};
    return {chain, normal, length_of_edge, -dot(normal, path.motion)};
}

CastFeature feature_of(const MeasuredFace& face, double along) {
    return {face.normal, face.chain.from.pair(), face.chain.to.pair(), along};
}

CastFeature feature_of(const MinkowskiVertex& vertex, DVec2 normal) {
    return {normal, vertex.pair(), vertex.pair(), 0.0};
}

// Contacts found so far: the first of all, and the first that is certain to exist.
class FirstContact {
public:
    void offer(const CastContact& contact, bool is_certain) {
        TUMBLE_CHECK(!(contact.lower > contact.fraction));
        TUMBLE_CHECK(!(contact.fraction > contact.upper));
        lower_ = std::min(lower_, contact.lower);
        if (is_certain) upper_ = std::min(upper_, contact.upper);
        const bool is_earlier = contact.fraction < first_.fraction;
        const bool is_tie = contact.fraction == first_.fraction && contact.rate > first_.rate;
        if (is_earlier || is_tie) first_ = contact;
    }

    CastContact result() const {
        CastContact contact = first_;
        contact.lower = std::max(0.0, lower_);
        if (upper_ < kNever) contact.upper = upper_;
        return contact;
    }

private:
    CastContact first_{kNever, kNever, kNever, -kNever, {}};
    double lower_ = kNever;
    double upper_ = kNever;
};

class Clip {
public:
    explicit Clip(const CastPath& path) : path_(path) {}

    void add_face(const MeasuredFace& face) {
        if (path_.length > 0.0) add_face_contact(face);
        measure_start_to_face(face);
    }

    // The vertex between two faces.
    void add_corner(const MeasuredFace& before, const MeasuredFace& after) {
        if (path_.length > 0.0) add_corner_contact(before, after);
        measure_start_to_vertex(after.chain.from);
    }

    ClippedPath result() const {
        TUMBLE_CHECK(path_.error >= 0.0);
        TUMBLE_CHECK(nearest_ >= 0.0);
        ClippedPath clipped;
        clipped.first = first_.result();
        clipped.start_distance = deepest_ < -path_.error ? deepest_ : nearest_;
        // If the cores are apart, one feature is the nearest. If they touch, all faces there must close.
        const bool is_apart = clipped.start_distance > 4.0 * path_.error;
        clipped.start = is_apart ? nearest_feature_ : facing_;
        clipped.start_rate = -dot(clipped.start.normal, path_.motion);
        clipped.approaches = closes(clipped.start_rate) && (is_apart || !is_blocked_);
        return clipped;
    }

private:
    // True if the rate exceeds rounding: that of a distance over the whole motion, and that of the rate itself.
    bool closes(double rate) const { return rate > path_.error && rate > 16.0 * kUnitRoundoff * path_.length; }

    void add_face_contact(const MeasuredFace& face) {
        const DVec2 v = path_.motion;
        const double outwards = path_.reach * cross(v, face.normal);
        const double side_from = cross(v, face.chain.from.w) + outwards, side_to = cross(v, face.chain.to.w) + outwards;
        if (!(side_from >= 0.0 && side_to < 0.0)) return;
        const double along = side_from / (side_from - side_to);
        TUMBLE_CHECK(along >= 0.0);
        TUMBLE_CHECK(along <= 1.0);
        const DVec2 contact =
            face.chain.from.w + along * (face.chain.to.w - face.chain.from.w) + path_.reach * face.normal;
        const double fraction = dot(v, contact) / path_.length / path_.length;
        if (fraction < 0.0) return;
        const double doubt = face.rate > 0.0 ? path_.error / face.rate : kNever;
        const double margin = path_.error * path_.length;
        const bool is_certain = side_from >= margin && side_to <= -margin;
        first_.offer({fraction, fraction - doubt, fraction + doubt, face.rate, feature_of(face, along)}, is_certain);
    }

    void add_corner_contact(const MeasuredFace& before, const MeasuredFace& after) {
        const CircleEntry circle = find_circle_entry(path_, after.chain.from.w);
        if (!circle.is_reached) return;
        TUMBLE_CHECK(circle.lower <= circle.upper);
        const bool is_round = path_.reach > kRound * path_.error;
        const DVec2 normal =
            is_round ? (1.0 / length(circle.from_center)) * circle.from_center : corner_normal(before, after);
        // With almost no curvature, the path may reach a face beside the vertex instead, within E / s.
        const double slower = std::min(before.rate, after.rate);
        const double doubt = !is_round && slower > 0.0 ? path_.error / slower : 0.0;
        const bool is_certain = is_round ? circle.is_certain : closes(slower);
        first_.offer(
            {circle.entry / path_.length, circle.lower / path_.length - doubt, circle.upper / path_.length + doubt,
             -dot(normal, path_.motion), feature_of(after.chain.from, normal)},
            is_certain);
    }

    // The normal at a sharp vertex: that of the face beside it that closes faster, or against the motion if there is
    // none.
    DVec2 corner_normal(const MeasuredFace& before, const MeasuredFace& after) const {
        const MeasuredFace& facing = before.rate > after.rate ? before : after;
        return facing.length > 0.0 ? facing.normal : (-1.0 / path_.length) * path_.motion;
    }

    void measure_start_to_vertex(const MinkowskiVertex& vertex) {
        const double away = length(vertex.w);
        if (away < nearest_) set_nearest(away, feature_of(vertex, (1.0 / away) * -vertex.w));
    }

    void measure_start_to_face(const MeasuredFace& face) {
        if (face.length == 0.0) {  // the difference is a point: every motion leaves it
            deepest_ = 0.0;
            is_blocked_ = true;
            return;
        }
        const DVec2 w = face.chain.from.w, edge = face.chain.edge;
        const double separation = cross(edge, w) / face.length;
        const double along = -dot(edge, w) / length_sq(edge);
        deepest_ = std::max(deepest_, separation);
        if (separation < -3.0 * path_.error) return;
        if (!closes(face.rate)) is_blocked_ = true;
        if (face.rate > fastest_) {
            fastest_ = face.rate;
            facing_ = feature_of(face, std::clamp(along, 0.0, 1.0));
        }
        const bool is_beside = along >= 0.0 && along <= 1.0;
        if (is_beside && std::abs(separation) < nearest_) set_nearest(std::abs(separation), feature_of(face, along));
    }

    void set_nearest(double away, const CastFeature& feature) {
        nearest_ = away;
        nearest_feature_ = feature;
    }

    CastPath path_;
    FirstContact first_;
    double nearest_ = kNever;  // from the origin to a face or vertex
    CastFeature nearest_feature_{};
    CastFeature facing_{};  // the face in front of the origin that closes fastest
    double fastest_ = -kNever;
    double deepest_ = -kNever;  // largest separation of the origin from the line of a face
    bool is_blocked_ = false;   // a face that touches the origin does not close
};

}  // namespace

ClippedPath clip_path(const CorePair& pair, const CastPath& path) {
    TUMBLE_CHECK(path.reach >= 0.0);
    TUMBLE_CHECK(path.length >= 0.0);
    DifferenceChain chain(pair);
    Clip clip(path);
    ChainFace next;
    chain.next(next);
    const MeasuredFace first = measure(next, path);
    clip.add_face(first);
    MeasuredFace before = first;
    std::int32_t faces = 1;
    for (; chain.next(next); ++faces) {
        const MeasuredFace face = measure(next, path);
        clip.add_face(face);
        clip.add_corner(before, face);
        before = face;
    }
    clip.add_corner(before, first);
    TUMBLE_CHECK(faces <= std::max(pair.a.count + pair.b.count, 1));
    ClippedPath clipped = clip.result();
    clipped.faces = faces;
    return clipped;
}

}  // namespace tumble
