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

using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Mask4 = long long __attribute__((vector_size(32)));  // all bits of a lane, or none

// What a register holds of N lanes: eight of them with AVX-512, else four.
template <int N>
struct Register {
    using Double = Double4;
    using Mask = Mask4;
    static constexpr int kWidth = 4;
};

#if defined(__AVX512F__)
using Double8 = double __attribute__((vector_size(64)));

template <int N>
    requires(N % 8 == 0)
struct Register<N> {
    using Double = Double8;
    using Mask = __mmask8;
    static constexpr int kWidth = 8;
};

// With masks of all lanes: g++ 12 warns of the undefined lanes that its other functions begin with.
inline constexpr __mmask8 kAll = 0xff;

TUMBLE_LANE_FUNCTION void take_larger(Double8& a, const Double8& b) { a = _mm512_maskz_max_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION void take_smaller(Double8& a, const Double8& b) { a = _mm512_maskz_min_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION void take_less(__mmask8& mask, const Double8& a, const Double8& b) { mask = _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
TUMBLE_LANE_FUNCTION void take_equal(__mmask8& mask, const Double8& a, const Double8& b) { mask = _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
TUMBLE_LANE_FUNCTION unsigned bits_of(__mmask8 mask) { return mask; }
TUMBLE_LANE_FUNCTION void replace(Double8& where, __mmask8 mask, const Double8& by) { where = _mm512_mask_mov_pd(where, mask, by); }
TUMBLE_LANE_FUNCTION void load_widened(Double8& part, const float* values) {
    part = _mm512_maskz_cvtps_pd(kAll, _mm256_loadu_ps(values));
}
TUMBLE_LANE_FUNCTION void widen(Double8& part, const Float4& low, const Float4& high) {
    part = _mm512_maskz_cvtps_pd(kAll, __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
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

// By intrinsics where there are any: of the compiler's own comparison g++ makes a mask register with AVX-512, and of that the
// lanes that blending and bits_of() need.
TUMBLE_LANE_FUNCTION void take_less(Mask4& mask, const Double4& a, const Double4& b) {
#if defined(__AVX__)
    mask = reinterpret_cast<Mask4>(_mm256_cmp_pd(a, b, _CMP_LT_OQ));
#else
    mask = a < b;
#endif
}

TUMBLE_LANE_FUNCTION void take_equal(Mask4& mask, const Double4& a, const Double4& b) {
#if defined(__AVX__)
    mask = reinterpret_cast<Mask4>(_mm256_cmp_pd(a, b, _CMP_EQ_OQ));
#else
    mask = a == b;
#endif
}

TUMBLE_LANE_FUNCTION unsigned bits_of(const Mask4& mask) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<Double4>(mask)));
#else
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<unsigned>(mask[i] != 0) << i;
    return bits;
#endif
}

TUMBLE_LANE_FUNCTION void replace(Double4& where, const Mask4& mask, const Double4& by) {
#if defined(__AVX__)
    where = _mm256_blendv_pd(where, by, reinterpret_cast<Double4>(mask));
#else
    where = mask ? by : where;
#endif
}

// The compiler's own conversion goes by halves that are then loaded whole, which waits for both.
TUMBLE_LANE_FUNCTION void widen(Double4& part, const Float4& values) {
#if defined(__AVX__)
    part = _mm256_cvtps_pd(values);
#else
    for (int lane = 0; lane < 4; ++lane) part[lane] = values[lane];
#endif
}

TUMBLE_LANE_FUNCTION void load_widened(Double4& part, const float* values) {
    Float4 four;
    std::memcpy(&four, values, sizeof four);
    widen(part, four);
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
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator-(const DoubleLanes& a) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = -a.part[i];
        return result;
    }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator*(double a, const DoubleLanes& b) { return DoubleLanes(a) * b; }
    TUMBLE_LANE_FUNCTION friend DoubleLanes operator/(const DoubleLanes& a, const DoubleLanes& b) {
        DoubleLanes result;
        for (int i = 0; i < kParts; ++i) result.part[i] = a.part[i] / b.part[i];
        return result;
    }
};

// A number of one pair as it is in a lane.
inline double square_root(double number) { return std::sqrt(number); }
inline double smaller(double a, double b) { return a < b ? a : b; }

// One of two for each lane.
template <int N>
struct MaskLanes {
    using Part = typename simd::Register<N>::Mask;

    Part part[DoubleLanes<N>::kParts];

    TUMBLE_LANE_FUNCTION friend MaskLanes operator&(const MaskLanes& a, const MaskLanes& b) {
        MaskLanes result;
        for (int i = 0; i < DoubleLanes<N>::kParts; ++i) result.part[i] = static_cast<Part>(a.part[i] & b.part[i]);
        return result;
    }
    TUMBLE_LANE_FUNCTION friend MaskLanes operator|(const MaskLanes& a, const MaskLanes& b) {
        MaskLanes result;
        for (int i = 0; i < DoubleLanes<N>::kParts; ++i) result.part[i] = static_cast<Part>(a.part[i] | b.part[i]);
        return result;
    }
    TUMBLE_LANE_FUNCTION friend MaskLanes operator~(const MaskLanes& a) {
        MaskLanes result;
        for (int i = 0; i < DoubleLanes<N>::kParts; ++i) result.part[i] = static_cast<Part>(~a.part[i]);
        return result;
    }
};

template <int N>
TUMBLE_LANE_FUNCTION MaskLanes<N> operator<(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    MaskLanes<N> result;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::take_less(result.part[i], a.part[i], b.part[i]);
    return result;
}

template <int N>
TUMBLE_LANE_FUNCTION MaskLanes<N> operator==(const DoubleLanes<N>& a, const DoubleLanes<N>& b) {
    MaskLanes<N> result;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::take_equal(result.part[i], a.part[i], b.part[i]);
    return result;
}

// Puts `by` where the mask says so.
template <int N>
TUMBLE_LANE_FUNCTION void replace(DoubleLanes<N>& where, const MaskLanes<N>& mask, const DoubleLanes<N>& by) {
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) simd::replace(where.part[i], mask.part[i], by.part[i]);
}

// mask ? x : y
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> select(const MaskLanes<N>& mask, const DoubleLanes<N>& x, const DoubleLanes<N>& y) {
    DoubleLanes<N> result = y;
    replace(result, mask, x);
    return result;
}

// Bit i is set where lane i is.
template <int N>
TUMBLE_LANE_FUNCTION unsigned bits_of(const MaskLanes<N>& mask) {
    unsigned bits = 0;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) bits |= simd::bits_of(mask.part[i]) << (DoubleLanes<N>::kWidth * i);
    return bits & ((1u << N) - 1u);
}

// number(i) in lane i, put together in registers: a wide load of what was just stored by single numbers waits for all of them.
template <int N, typename Number>
TUMBLE_LANE_FUNCTION DoubleLanes<N> gather_lanes(const Number& number) {
    DoubleLanes<N> lanes;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) {
        const int k = DoubleLanes<N>::kWidth * i;
        if constexpr (DoubleLanes<N>::kWidth == 8)
            lanes.part[i] = typename DoubleLanes<N>::Part{number(k), number(k + 1), number(k + 2), number(k + 3),
                                                          number(k + 4), number(k + 5), number(k + 6), number(k + 7)};
        else
            lanes.part[i] = typename DoubleLanes<N>::Part{number(k), number(k + 1), number(k + 2), number(k + 3)};
    }
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

// The lowest so far in each lane, and the index it was met with first.
template <int N>
struct LowestLanes {
    DoubleLanes<N> value;
    DoubleLanes<N> index{0.0};
};

template <int N>
TUMBLE_LANE_FUNCTION void take_lower(LowestLanes<N>& lowest, const DoubleLanes<N>& other, double index) {
    replace(lowest.index, other < lowest.value, DoubleLanes<N>(index));
    lowest.value = smaller(lowest.value, other);
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

}  // namespace tumble
