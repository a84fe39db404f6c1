// Four or eight double lanes, for what is computed about all vertices of a small shape at once.
//
// On the compilers' vector types, whose + - * / are packed on every instruction set and round as the scalars do. The order
// of sums does not depend on a register's width, and the largest of all lanes does not either: comparing rounds nothing.
#pragma once

#include <cmath>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "simd/lane_function.hpp"

namespace tumble {

namespace simd {

using Double4 = double __attribute__((vector_size(32)));
using Index4 = long long __attribute__((vector_size(32)));

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

}  // namespace simd

template <int N>
struct DoubleLanes {
    static_assert(N % 4 == 0);
    static constexpr int kParts = N / 4;

    simd::Double4 part[kParts];

    DoubleLanes() = default;
    TUMBLE_LANE_FUNCTION explicit DoubleLanes(double all) {
        for (int i = 0; i < kParts; ++i) part[i] = simd::Double4{all, all, all, all};
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

// N floats, widened; the compiler's own conversion goes by halves that are then loaded whole, which waits for both.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> load_widened(const float* values) {
    DoubleLanes<N> result;
    for (int i = 0; i < N / 4; ++i) {
#if defined(__AVX__)
        result.part[i] = _mm256_cvtps_pd(_mm_loadu_ps(values + 4 * i));
#else
        for (int lane = 0; lane < 4; ++lane) result.part[i][lane] = values[4 * i + lane];
#endif
    }
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> square_root(const DoubleLanes<N>& lanes) {
    DoubleLanes<N> result;
    for (int i = 0; i < N / 4; ++i) {
#if defined(__AVX__)
        result.part[i] = _mm256_sqrt_pd(lanes.part[i]);
#else
        for (int lane = 0; lane < 4; ++lane) result.part[i][lane] = std::sqrt(lanes.part[i][lane]);
#endif
    }
    return result;
}

// For each lane: condition > 0 ? x : y. A NaN selects y.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> select_positive(const DoubleLanes<N>& condition, const DoubleLanes<N>& x,
                                                    const DoubleLanes<N>& y) {
    DoubleLanes<N> result;
    for (int i = 0; i < N / 4; ++i) result.part[i] = condition.part[i] > simd::Double4{} ? x.part[i] : y.part[i];
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> larger(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    DoubleLanes<N> result = a;
    for (int i = 0; i < N / 4; ++i) simd::take_larger(result.part[i], b.part[i]);
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> smaller(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    DoubleLanes<N> result = a;
    for (int i = 0; i < N / 4; ++i) simd::take_smaller(result.part[i], b.part[i]);
    return result;
}

// An index a lane.
template <int N>
struct IndexLanes {
    simd::Index4 part[N / 4];

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
    for (int i = 0; i < N / 4; ++i) lowest.index.part[i] = simd::Index4{};
    return lowest;
}

// Keeps the earlier one of equals.
template <int N>
TUMBLE_LANE_FUNCTION void take_lower(LowestLanes<N>& lowest, const DoubleLanes<N>& other, long long index) {
    for (int i = 0; i < N / 4; ++i) {
        const simd::Index4 is_lower = other.part[i] < lowest.value.part[i];
        lowest.index.part[i] = is_lower ? simd::Index4{index, index, index, index} : lowest.index.part[i];
        simd::take_smaller(lowest.value.part[i], other.part[i]);
    }
}

// One lane in all lanes.
template <int Lane, int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> spread(const DoubleLanes<N>& lanes) {
    const simd::Double4 from = lanes.part[Lane / 4];
    DoubleLanes<N> result;
    result.part[0] = __builtin_shufflevector(from, from, Lane % 4, Lane % 4, Lane % 4, Lane % 4);
    for (int i = 1; i < N / 4; ++i) result.part[i] = result.part[0];
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
    result.part[0] = __builtin_shufflevector(lanes.part[0], lanes.part[1], 1, 2, 3, 4);
    result.part[1] = __builtin_shufflevector(lanes.part[1], lanes.part[0], 1, 2, 3, 4);
    return result;
}

// The largest of all lanes; no lane may be NaN.
template <int N>
TUMBLE_LANE_FUNCTION double largest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = lanes.part[0];
    for (int i = 1; i < N / 4; ++i) simd::take_larger(four, lanes.part[i]);
    simd::take_larger(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_larger(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return four[0];
}

// The smallest, likewise.
template <int N>
TUMBLE_LANE_FUNCTION double smallest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = lanes.part[0];
    for (int i = 1; i < N / 4; ++i) simd::take_smaller(four, lanes.part[i]);
    simd::take_smaller(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_smaller(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return four[0];
}

// Bit i is set where lane i is this value.
template <int N>
TUMBLE_LANE_FUNCTION unsigned lanes_equal_to(const DoubleLanes<N>& lanes, double value) {
    const DoubleLanes<N> values(value);
    unsigned bits = 0;
    for (int i = 0; i < N / 4; ++i) bits |= simd::equal_bits(lanes.part[i], values.part[i]) << (4 * i);
    return bits;
}

// Bit i is set where lane i is less.
template <int N>
TUMBLE_LANE_FUNCTION unsigned lanes_less_than(const DoubleLanes<N>& lanes, double value) {
    const DoubleLanes<N> values(value);
    unsigned bits = 0;
    for (int i = 0; i < N / 4; ++i) bits |= simd::less_bits(lanes.part[i], values.part[i]) << (4 * i);
    return bits;
}

}  // namespace tumble
