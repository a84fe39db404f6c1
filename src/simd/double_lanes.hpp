// Four or eight double lanes, for what is computed about all vertices of a small shape at once.
//
// On the compilers' vector types, whose + - * / are packed on every instruction set and round as the scalars do. The order
// of sums does not depend on a register's width, and the largest of all lanes does not either: comparing rounds nothing.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "simd/lane_function.hpp"

namespace tumble {

namespace simd {

using Double4 = double __attribute__((vector_size(32)));
using Index4 = long long __attribute__((vector_size(32)));

// What a register holds of N lanes: eight of them with AVX-512, else four.
template <int N>
struct Register {
    using Double = Double4;
    using Index = Index4;
    static constexpr int kWidth = 4;
};

#if defined(__AVX512F__)
using Double8 = double __attribute__((vector_size(64)));
using Index8 = long long __attribute__((vector_size(64)));

template <int N>
    requires(N % 8 == 0)
struct Register<N> {
    using Double = Double8;
    using Index = Index8;
    static constexpr int kWidth = 8;
};

// With masks of all lanes: g++ 12 warns of the undefined lanes that its other functions begin with.
inline constexpr __mmask8 kAll = 0xff;

TUMBLE_LANE_FUNCTION void take_larger(Double8& a, const Double8& b) { a = _mm512_maskz_max_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION void take_smaller(Double8& a, const Double8& b) { a = _mm512_maskz_min_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION unsigned equal_bits(const Double8& a, const Double8& b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
TUMBLE_LANE_FUNCTION unsigned less_bits(const Double8& a, const Double8& b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
TUMBLE_LANE_FUNCTION void load_widened(Double8& part, const float* values) {
    part = _mm512_maskz_cvtps_pd(kAll, _mm256_loadu_ps(values));
}
TUMBLE_LANE_FUNCTION void take_root(Double8& part) { part = _mm512_maskz_sqrt_pd(kAll, part); }
TUMBLE_LANE_FUNCTION Double4 larger_halves(const Double8& part) {
    return _mm256_max_pd(__builtin_shufflevector(part, part, 0, 1, 2, 3), __builtin_shufflevector(part, part, 4, 5, 6, 7));
}
TUMBLE_LANE_FUNCTION Double4 smaller_halves(const Double8& part) {
    return _mm256_min_pd(__builtin_shufflevector(part, part, 0, 1, 2, 3), __builtin_shufflevector(part, part, 4, 5, 6, 7));
}
#endif

TUMBLE_LANE_FUNCTION void take_larger(Double4& a, const Double4& b) {
#if defined(__AVX__)
    a = _mm256_max_pd(a, b);
#else
    a = a > b ? a : b;
#endif
}

TUMBLE_LANE_FUNCTION void take_smaller(Double4& a, const Double4& b) {
#if defined(__AVX__)
    a = _mm256_min_pd(a, b);
#else
    a = a < b ? a : b;
#endif
}

// Bit i is set where lane i of a equals lane i of b.
TUMBLE_LANE_FUNCTION unsigned equal_bits(const Double4& a, const Double4& b) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_EQ_OQ)));
#else
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<unsigned>(a[i] == b[i]) << i;
    return bits;
#endif
}

TUMBLE_LANE_FUNCTION unsigned less_bits(const Double4& a, const Double4& b) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
#else
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<unsigned>(a[i] < b[i]) << i;
    return bits;
#endif
}

// Four floats, widened; the compiler's own conversion goes by halves that are then loaded whole, which waits for both.
TUMBLE_LANE_FUNCTION void load_widened(Double4& part, const float* values) {
#if defined(__AVX__)
    part = _mm256_cvtps_pd(_mm_loadu_ps(values));
#else
    for (int lane = 0; lane < 4; ++lane) part[lane] = values[lane];
#endif
}

TUMBLE_LANE_FUNCTION void take_root(Double4& part) {
#if defined(__AVX__)
    part = _mm256_sqrt_pd(part);
#else
    for (int lane = 0; lane < 4; ++lane) part[lane] = std::sqrt(part[lane]);
#endif
}

TUMBLE_LANE_FUNCTION const Double4& larger_halves(const Double4& part) { return part; }
TUMBLE_LANE_FUNCTION const Double4& smaller_halves(const Double4& part) { return part; }

}  // namespace simd

template <int N>
struct DoubleLanes {
    static_assert(N % 4 == 0);
    using Part = typename simd::Register<N>::Double;
    static constexpr int kWidth = simd::Register<N>::kWidth, kParts = N / kWidth;

    Part part[kParts];

    DoubleLanes() = default;
    TUMBLE_LANE_FUNCTION explicit DoubleLanes(double all) {
        for (int i = 0; i < kParts; ++i) part[i] = Part{} + all;
    }

    [[gnu::always_inline]] double operator[](int lane) const {
        double value;
        std::memcpy(&value, reinterpret_cast<const char*>(part) + sizeof(double) * static_cast<unsigned>(lane), sizeof value);
        return value;
    }

    TUMBLE_LANE_FUNCTION friend DoubleLanes operator+(const DoubleLanes& a, const DoubleLanes& b) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = a.part[i] + b.part[i];
        return result;
    }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator-(const DoubleLanes& a, const DoubleLanes& b) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = a.part[i] - b.part[i];
        return result;
    }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator*(const DoubleLanes& a, const DoubleLanes& b) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = a.part[i] * b.part[i];
        return result;
    }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator*(double a, const DoubleLanes& b) { return DoubleLanes(a) * b; }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator/(const DoubleLanes& a, const DoubleLanes& b) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = a.part[i] / b.part[i];
        return result;
    }
};

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> load_lanes(const double (&values)[N]) {
    DoubleLanes<N> lanes;
    std::memcpy(lanes.part, values, sizeof values);
    return lanes;
}

// N floats, widened.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> load_widened(const float* values) {
    DoubleLanes<N> result;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::load_widened(result.part[i], values + DoubleLanes<N>::kWidth * i);
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> square_root(const DoubleLanes<N>& lanes) {
    DoubleLanes<N> result = lanes;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::take_root(result.part[i]);
    return result;
}

// For each lane: condition > 0 ? x : y. A NaN selects y.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> select_positive(const DoubleLanes<N>& condition, const DoubleLanes<N>& x,
                                                    const DoubleLanes<N>& y) {
    DoubleLanes<N> result;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) result.part[i] = condition.part[i] > typename DoubleLanes<N>::Part{} ? x.part[i] : y.part[i];
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> larger(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    DoubleLanes<N> result = a;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::take_larger(result.part[i], b.part[i]);
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> smaller(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    DoubleLanes<N> result = a;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::take_smaller(result.part[i], b.part[i]);
    return result;
}

// An index a lane.
template <int N>
struct IndexLanes {
    using Part = typename simd::Register<N>::Index;

    Part part[N / simd::Register<N>::kWidth];

    [[gnu::always_inline]] int operator[](int lane) const {
        long long value;
        std::memcpy(&value, reinterpret_cast<const char*>(part) + sizeof value * static_cast<unsigned>(lane), sizeof value);
        return static_cast<int>(value);
    }
};

template <int N>
struct LowestLanes {
    DoubleLanes<N> value;
    IndexLanes<N> index;
};

template <int N>
TUMBLE_LANE_FUNCTION LowestLanes<N> begin_lowest(const DoubleLanes<N>& first) {
    LowestLanes<N> lowest{first, {}};
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) lowest.index.part[i] = typename IndexLanes<N>::Part{};
    return lowest;
}

// Keeps the earlier one of equals.
template <int N>
TUMBLE_LANE_FUNCTION void take_lower(LowestLanes<N>& lowest, const DoubleLanes<N>& other, long long index) {
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) {
        const typename IndexLanes<N>::Part is_lower = other.part[i] < lowest.value.part[i];
        lowest.index.part[i] = is_lower ? typename IndexLanes<N>::Part{} + index : lowest.index.part[i];
        simd::take_smaller(lowest.value.part[i], other.part[i]);
    }
}

// The largest so far in each lane, the index it was met with first, and whether it was met again: all bits set, else none.
template <int N>
struct LargestLanes {
    DoubleLanes<N> value;
    IndexLanes<N> index;
    IndexLanes<N> tied;
};

template <int N>
TUMBLE_LANE_FUNCTION LargestLanes<N> begin_largest() {
    LargestLanes<N> largest{DoubleLanes<N>(-std::numeric_limits<double>::infinity()), {}, {}};
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) largest.index.part[i] = largest.tied.part[i] = typename IndexLanes<N>::Part{};
    return largest;
}

template <int N>
TUMBLE_LANE_FUNCTION void take_larger(LargestLanes<N>& largest, const DoubleLanes<N>& other, long long index) {
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) {
        const typename IndexLanes<N>::Part is_larger = other.part[i] > largest.value.part[i],
                                           is_equal = other.part[i] == largest.value.part[i];
        largest.index.part[i] = is_larger ? typename IndexLanes<N>::Part{} + index : largest.index.part[i];
        largest.tied.part[i] = is_equal | (largest.tied.part[i] & ~is_larger);
        simd::take_larger(largest.value.part[i], other.part[i]);
    }
}

// One lane in all lanes.
template <int Lane, int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> spread(const DoubleLanes<N>& lanes) {
    constexpr int kWidth = DoubleLanes<N>::kWidth, kFrom = Lane % kWidth;
    const typename DoubleLanes<N>::Part from = lanes.part[Lane / kWidth];
    DoubleLanes<N> result;
    if constexpr (kWidth == 8)
        result.part[0] = __builtin_shufflevector(from, from, kFrom, kFrom, kFrom, kFrom, kFrom, kFrom, kFrom, kFrom);
    else
        result.part[0] = __builtin_shufflevector(from, from, kFrom, kFrom, kFrom, kFrom);
    for (int i = 1; i < DoubleLanes<N>::kParts; ++i) result.part[i] = result.part[0];
    return result;
}

// Lane i + 1 in lane i, and lane 0 in the last.
TUMBLE_LANE_FUNCTION DoubleLanes<4> next_lanes(const DoubleLanes<4>& lanes) {
    DoubleLanes<4> result;
    result.part[0] = __builtin_shufflevector(lanes.part[0], lanes.part[0], 1, 2, 3, 0);
    return result;
}
TUMBLE_LANE_FUNCTION DoubleLanes<8> next_lanes(const DoubleLanes<8>& lanes) {
    DoubleLanes<8> result;
#if defined(__AVX512F__)
    result.part[0] = __builtin_shufflevector(lanes.part[0], lanes.part[0], 1, 2, 3, 4, 5, 6, 7, 0);
#else
    result.part[0] = __builtin_shufflevector(lanes.part[0], lanes.part[1], 1, 2, 3, 4);
    result.part[1] = __builtin_shufflevector(lanes.part[1], lanes.part[0], 1, 2, 3, 4);
#endif
    return result;
}

// The largest of all lanes; no lane may be NaN.
template <int N>
TUMBLE_LANE_FUNCTION double largest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = simd::larger_halves(lanes.part[0]);
    for (int i = 1; i < DoubleLanes<N>::kParts; ++i) simd::take_larger(four, simd::larger_halves(lanes.part[i]));
    simd::take_larger(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_larger(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return four[0];
}

// The smallest, likewise.
template <int N>
TUMBLE_LANE_FUNCTION double smallest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = simd::smaller_halves(lanes.part[0]);
    for (int i = 1; i < DoubleLanes<N>::kParts; ++i) simd::take_smaller(four, simd::smaller_halves(lanes.part[i]));
    simd::take_smaller(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_smaller(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return four[0];
}

// Bit i is set where lane i is this value.
template <int N>
TUMBLE_LANE_FUNCTION unsigned lanes_equal_to(const DoubleLanes<N>& lanes, double value) {
    const DoubleLanes<N> values(value);
    unsigned bits = 0;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) bits |= simd::equal_bits(lanes.part[i], values.part[i]) << (DoubleLanes<N>::kWidth * i);
    return bits;
}

// Bit i is set where lane i is less.
template <int N>
TUMBLE_LANE_FUNCTION unsigned lanes_less_than(const DoubleLanes<N>& lanes, double value) {
    const DoubleLanes<N> values(value);
    unsigned bits = 0;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) bits |= simd::less_bits(lanes.part[i], values.part[i]) << (DoubleLanes<N>::kWidth * i);
    return bits;
}

}  // namespace tumble
