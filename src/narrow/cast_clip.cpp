#include "narrow/cast_clip.hpp"

#include <algorithm>
#include <limits>

#include "narrow/cast_chain.hpp"
#include "narrow/error_bound.hpp"

namespace tumble {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// A face with what both its ends and its line need.
struct MeasuredFace {
    ChainFace chain;
    DVec2 normal;     // unit, outwards; zero for a difference that is a point
    double length;
    double rate;      // at which the face closes: -normal . v
};

MeasuredFace measure(const ChainFace& chain, const CastPath& path) {
    const double length_of_edge = length(chain.edge);
    const DVec2 normal = length_of_edge > 0.0 ? (1.0 / length_of_edge) * -perp(chain.edge) : DVec2{};
    return {chain, normal, length_of_edge, -dot(normal, path.motion)};
}

CastFeature feature_of(const MeasuredFace& face, double along) {
    return {face.normal, face.chain.from.pair(), face.chain.to.pair(), along};
}

CastFeature feature_of(const MinkowskiVertex& vertex, DVec2 normal) { return {normal, vertex.pair(), vertex.pair(), 0.0}; }

// Contacts found so far: the first of all, and the first that is certain to exist.
class FirstContact {
public:
    void offer(const CastContact& contact, bool is_certain) {
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
        if (path_.length > 0.0) meet_face(face);
        see_face(face);
    }

    // The vertex between two faces.
    void add_corner(const MeasuredFace& before, const MeasuredFace& after) {
        if (path_.length > 0.0) meet_corner(before, after);
        see_vertex(after.chain.from);
    }

    ClippedPath result() const {
        ClippedPath clipped;
        clipped.first = first_.result();
        clipped.start_distance = deepest_ < -path_.error ? deepest_ : nearest_;
        // Where the cores are apart one feature is the nearest; where they touch, all faces there have to close.
        const bool is_apart = clipped.start_distance > 4.0 * path_.error;
        clipped.start = is_apart ? nearest_feature_ : facing_;
        clipped.start_rate = -dot(clipped.start.normal, path_.motion);
        clipped.approaches = closes(clipped.start_rate) && (is_apart || !is_held_);
        return clipped;
    }

private:
    // By more than rounding within the motion, and than the rounding of the rate.
    bool closes(double rate) const {
        return rate > path_.error && rate > 16.0 * kUnitRoundoff * path_.length;
    }

    void meet_face(const MeasuredFace& face) {
        const DVec2 v = path_.motion;
        const double outwards = path_.reach * cross(v, face.normal);
        const double side_from = cross(v, face.chain.from.w) + outwards, side_to = cross(v, face.chain.to.w) + outwards;
        if (!(side_from >= 0.0 && side_to < 0.0)) return;
        const double along = side_from / (side_from - side_to);
        const DVec2 met = face.chain.from.w + along * (face.chain.to.w - face.chain.from.w) + path_.reach * face.normal;
        const double fraction = dot(v, met) / path_.length / path_.length;
        if (fraction < 0.0) return;
        const double doubt = face.rate > 0.0 ? path_.error / face.rate : kNever;
        const double margin = path_.error * path_.length;
        const bool is_certain = side_from >= margin && side_to <= -margin;
        first_.offer({fraction, fraction - doubt, fraction + doubt, face.rate, feature_of(face, along)}, is_certain);
    }

    // The distance along the path at which it enters a circle around a point `ahead` m on and `aside` m off.
    static double enter_circle(double ahead, double aside, double radius) {
        return ahead - std::sqrt(std::max(0.0, (radius - aside) * (radius + aside)));
    }

    void meet_corner(const MeasuredFace& before, const MeasuredFace& after) {
        const DVec2 w = after.chain.from.w, heading = (1.0 / path_.length) * path_.motion;
        const double ahead = dot(heading, w), offside = cross(heading, w), aside = std::abs(offside);
        if (!(ahead > 0.0 && aside <= path_.reach + path_.error)) return;
        const double entry = enter_circle(ahead, aside, path_.reach);
        if (entry < 0.0) return;
        const double error = 2.0 * path_.error;
        double lower = enter_circle(ahead, aside, path_.reach + error) - path_.error;
        double upper = enter_circle(ahead, aside, std::max(0.0, path_.reach - error)) + path_.error;
        bool is_certain = aside <= path_.reach - path_.error;
        DVec2 normal;
        if (path_.reach > 16.0 * path_.error) {
            const DVec2 from_center = (entry - ahead) * heading - offside * perp(heading);
            normal = (1.0 / length(from_center)) * from_center;
        } else {
            const MeasuredFace& facing = before.rate > after.rate ? before : after;
            normal = facing.length > 0.0 ? facing.normal : -heading;
            const double slower = std::min(before.rate, after.rate);
            const double doubt = slower > 0.0 ? path_.error * path_.length / slower : 0.0;
            lower -= doubt;
            upper += doubt;
            is_certain = closes(slower);
        }
        first_.offer({entry / path_.length, lower / path_.length, upper / path_.length, -dot(normal, path_.motion),
                      feature_of(after.chain.from, normal)}, is_certain);
    }

    void see_vertex(const MinkowskiVertex& vertex) {
        const double away = length(vertex.w);
        if (away < nearest_) see_nearest(away, feature_of(vertex, (1.0 / away) * -vertex.w));
    }

    void see_face(const MeasuredFace& face) {
        if (face.length == 0.0) {  // a difference that is a point: all motion leaves it
            deepest_ = 0.0;
            is_held_ = true;
            return;
        }
        const DVec2 w = face.chain.from.w, edge = face.chain.edge;
        const double separation = cross(edge, w) / face.length;
        const double along = -dot(edge, w) / length_sq(edge);
        deepest_ = std::max(deepest_, separation);
        if (separation < -3.0 * path_.error) return;
        if (!closes(face.rate)) is_held_ = true;
        if (face.rate > fastest_) {
            fastest_ = face.rate;
            facing_ = feature_of(face, std::clamp(along, 0.0, 1.0));
        }
        const bool is_beside = along >= 0.0 && along <= 1.0;
        if (is_beside && std::abs(separation) < nearest_) see_nearest(std::abs(separation), feature_of(face, along));
    }

    void see_nearest(double away, const CastFeature& feature) {
        nearest_ = away;
        nearest_feature_ = feature;
    }

    CastPath path_;
    FirstContact first_;
    double nearest_ = kNever;   // from the origin to a face or vertex
    CastFeature nearest_feature_{};
    CastFeature facing_{};      // the face in front of the origin that closes fastest
    double fastest_ = -kNever;
    double deepest_ = -kNever;  // largest separation of the origin from the line of a face
    bool is_held_ = false;      // a face that touches the origin does not close
};

}  // namespace

ClippedPath clip_path(const CorePair& pair, const CastPath& path) {
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
    ClippedPath clipped = clip.result();
    clipped.faces = faces;
    return clipped;
}

}  // namespace tumble
