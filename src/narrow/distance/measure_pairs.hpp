// Core distances of many pairs of small cores at once, one pair in each lane. They have the same bits as those of
// measure_cores() without a cache.
#pragma once

#include "debug/check.hpp"
#include "narrow/distance/core_distance.hpp"
#include "narrow/faces/faces_of_pairs.hpp"

namespace tumble {

template <int N>
class MeasuredPairs {
public:
    TUMBLE_LANE_FUNCTION explicit MeasuredPairs(const CorePairs<N>& pairs) : leading_(pairs) {
        const PairLanes zero(0.0), error = error_bound(pairs.scale);
        const FaceNumbers<PairLanes>& face = leading_.face;
        const FaceMeasure<PairLanes> by_face = measure(face, select(leading_.is_b, -pairs.offset_x, pairs.offset_x),
                                                       select(leading_.is_b, -pairs.offset_y, pairs.offset_y));
        distance_ = face.separation;
        lower_ = face.separation - error;
        upper_ = face.separation + error;
        direction_x_ = select(leading_.is_b, -face.outward_x, face.outward_x);
        direction_y_ = select(leading_.is_b, -face.outward_y, face.outward_y);
        normal_x_ = select(leading_.is_b, -by_face.normal_x, by_face.normal_x);
        normal_y_ = select(leading_.is_b, -by_face.normal_y, by_face.normal_y);
        on_a_x_ = select(leading_.is_b, face.other_x, by_face.own_x);
        on_a_y_ = select(leading_.is_b, face.other_y, by_face.own_y);
        on_b_x_ = select(leading_.is_b, by_face.own_x, face.other_x);
        on_b_y_ = select(leading_.is_b, by_face.own_y, face.other_y);

        const PairMask beyond_first = ~(by_face.before < zero), beyond_second = ~(zero < by_face.behind);
        const PairMask is_inside = ~(beyond_first | beyond_second), is_apart = zero < lower_;
        const PairMask is_valid =
            leading_.exists() & (PairLanes(kSmallestScale) < pairs.scale) & (pairs.scale < PairLanes(kLargestScale));
        ends_first_ = bits_of(beyond_first);
        by_face_ = bits_of(is_valid & is_inside & (is_apart | (upper_ < zero)));
        by_vertex_ = bits_of(is_valid & ~is_inside & is_apart & ~leading_.is_tied);
        TUMBLE_CHECK((by_face_ & by_vertex_) == 0u);
        if (by_vertex_ != 0) measure_ends(pairs, beyond_first, is_inside);
    }

    bool is_decided(int lane) const { return ((by_face_ | by_vertex_) >> lane & 1u) != 0; }

    // The distance of a decided pair.
    TUMBLE_LANE_FUNCTION CoreDistance operator()(int lane, const Shape& a, const Shape& b) const {
        TUMBLE_CHECK(is_decided(lane));
        CoreDistance core;
        core.distance = distance_[lane];
        core.lower = lower_[lane];
        core.upper = upper_[lane];
        core.direction.x = direction_x_[lane];
        core.direction.y = direction_y_[lane];
        core.normal.x = normal_x_[lane];
        core.normal.y = normal_y_[lane];
        core.on_a.x = on_a_x_[lane];
        core.on_a.y = on_a_y_[lane];
        core.on_b.x = on_b_x_[lane];
        core.on_b.y = on_b_y_[lane];
        const int edge = static_cast<int>(leading_.edge[lane]), from = edge % N,
                  nearest = static_cast<int>(leading_.nearest[lane]);
        const unsigned is_b = edge >= N;
        const int counts[2] = {a.vertex_count(), b.vertex_count()};
        TUMBLE_CHECK(from < counts[is_b]);
        TUMBLE_CHECK(nearest < counts[1 - is_b]);
        const int to = from + 1 == counts[is_b] ? 0 : from + 1;
        const VertexPair first = pair_of_owner(is_b, from, nearest), second = pair_of_owner(is_b, to, nearest);
        const bool is_face = (by_face_ >> lane & 1u) != 0, ends_first = (ends_first_ >> lane & 1u) != 0;
        core.pairs[0] = is_face || ends_first ? first : second;
        core.pairs[1] = !is_face && ends_first ? first : second;
        core.pair_count = is_face ? 2 : 1;
        core.overlap = is_face && core.upper < 0.0;
        TUMBLE_CHECK(core.lower <= core.upper);
        core.iterations = 2;
        return core;
    }

private:
    // By the vertices at the ends of the leading faces, in the lanes where these may decide.
    TUMBLE_LANE_FUNCTION void measure_ends(const CorePairs<N>& pairs, const PairMask& beyond_first,
                                           const PairMask& is_inside) {
        const CoreOfPairs<N>&a = pairs.a, &b = pairs.b;
        const FaceNumbers<PairLanes>& face = leading_.face;
        const PairLanes end_x = select(beyond_first, face.first_x, face.second_x),
                        end_y = select(beyond_first, face.first_y, face.second_y);
        const PairLanes a_x = select(leading_.is_b, face.other_x, end_x),
                        a_y = select(leading_.is_b, face.other_y, end_y);
        const PairLanes b_x = select(leading_.is_b, end_x, face.other_x),
                        b_y = select(leading_.is_b, end_y, face.other_y);
        const PairLanes x = to_origin(a_x, b_x, pairs.offset_x), y = to_origin(a_y, b_y, pairs.offset_y);
        PairLanes height_a = x * a.x[0] + y * a.y[0], lowest_b = x * b.x[0] + y * b.y[0];
        for (int i = 1; i < N; ++i) {
            height_a = larger(height_a, x * a.x[i] + y * a.y[i]);
            lowest_b = smaller(lowest_b, x * b.x[i] + y * b.y[i]);
        }
        const VertexMeasure<PairLanes> by_vertex =
            measure_vertex(x, y, height_a, lowest_b, pairs.offset_x, pairs.offset_y);
        const PairLanes error = error_bound(pairs.scale), lower = by_vertex.proved - error;
        const PairMask is_proved =
            ~(progress_bound(pairs.scale) * by_vertex.distance < by_vertex.distance_sq + by_vertex.height) &
            (PairLanes(0.0) < lower);
        by_vertex_ &= bits_of(is_proved);
        const PairMask is_end = ~is_inside;
        replace(distance_, is_end, by_vertex.distance);
        replace(lower_, is_end, lower);
        replace(upper_, is_end, by_vertex.distance + error);
        replace(direction_x_, is_end, x);
        replace(direction_y_, is_end, y);
        replace(normal_x_, is_end, by_vertex.normal_x);
        replace(normal_y_, is_end, by_vertex.normal_y);
        replace(on_a_x_, is_end, a_x);
        replace(on_a_y_, is_end, a_y);
        replace(on_b_x_, is_end, b_x);
        replace(on_b_y_, is_end, b_y);
    }

    LeadingFaceOfPairs<N> leading_;
    PairLanes distance_, lower_, upper_, direction_x_, direction_y_, normal_x_, normal_y_, on_a_x_, on_a_y_, on_b_x_,
        on_b_y_;
    unsigned by_face_, by_vertex_, ends_first_;
};

}  // namespace tumble
