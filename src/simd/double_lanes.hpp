// Four or eight double lanes, for computations on all vertices of a small shape at once.
//
// They are made of the compilers' vector types, whose + - * / are packed on every instruction set and round as scalars
// do. No result depends on the width of a register: there are no sums of lanes, and the largest or smallest of all
// lanes is found without rounding.
#pragma once

#include <cmath>
#include <cstring>

#include "simd/double_register.hpp"

namespace tumble {

template <int N>
struct DoubleLanes {
    static_assert(N % 4 == 0);
    using Part = typename simd::Register<N>::Double;
    static constexpr int kWidth = simd::Register<N>::kWidth, kParts = N / kWidth;

    Part part[kParts];

    DoubleLanes() = default;
    TUMBLE_LANE_FUNCTION explicit DoubleLanes(double all) {
        for (int i = 0; i < kParts; ++i) {
            if constexpr (kWidth == 8)
                part[i] = Part{all, all, all, all, all, all, all, all};
            else
                part[i] = Part{all, all, all, all};
        }
    }

    [[gnu::always_inline]] double operator[](int lane) const {
        double value;
        std::memcpy(&value, reinterpret_cast<const char*>(part) + sizeof(double) * static_cast<unsigned>(lane),
                    sizeof value);
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

// The scalar forms of lane functions, for templates on both.
inline double square_root(double number) { return std::sqrt(number); }
inline double smaller(double a, double b) { return a < b ? a : b; }

// A truth value for each lane.
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

// Replaces the lanes where the mask is true by those of `by`.
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

// Bit i is set if lane i is true.
template <int N>
TUMBLE_LANE_FUNCTION unsigned bits_of(const MaskLanes<N>& mask) {
    unsigned bits = 0;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i)
        bits |= simd::bits_of(mask.part[i]) << (DoubleLanes<N>::kWidth * i);
    return bits & ((1u << N) - 1u);
}

// Lane i is number(i). The lanes are assembled in registers: a wide load after scalar stores would wait for all of
// them.
template <int N, typename Number>
TUMBLE_LANE_FUNCTION DoubleLanes<N> gather_lanes(const Number& number) {
    DoubleLanes<N> lanes;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i) {
        const int k = DoubleLanes<N>::kWidth * i;
        if constexpr (DoubleLanes<N>::kWidth == 8)
            lanes.part[i] = typename DoubleLanes<N>::Part{number(k),     number(k + 1), number(k + 2), number(k + 3),
                                                          number(k + 4), number(k + 5), number(k + 6), number(k + 7)};
        else
            lanes.part[i] = typename DoubleLanes<N>::Part{number(k), number(k + 1), number(k + 2), number(k + 3)};
    }
    return lanes;
}

// N consecutive floats, widened to double.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> load_widened(const float* values) {
    DoubleLanes<N> result;
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i)
        simd::load_widened(result.part[i], values + DoubleLanes<N>::kWidth * i);
    return result;
}

// Stores the lanes, rounded to float, as N consecutive floats.
template <int N>
TUMBLE_LANE_FUNCTION void store_narrowed(const DoubleLanes<N>& lanes, float* values) {
    for (int i = 0; i < DoubleLanes<N>::kParts; ++i)
        simd::store_narrowed(lanes.part[i], values + DoubleLanes<N>::kWidth * i);
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

// The lowest value so far in each lane, and the index of its first occurrence.
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

// Copies lane `Lane` to all lanes.
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

// Rotates the lanes: lane i of the result is lane i + 1, the last lane is lane 0.
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

// The first lane, without a detour through memory.
template <int N>
TUMBLE_LANE_FUNCTION double first_lane(const DoubleLanes<N>& lanes) {
    return lanes.part[0][0];
}

namespace simd {

// Copies four lanes to all.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> spread(const Double4& four) {
    DoubleLanes<N> result;
    if constexpr (DoubleLanes<N>::kWidth == 8)
        result.part[0] = __builtin_shufflevector(four, four, 0, 1, 2, 3, 0, 1, 2, 3);
    else
        for (int i = 0; i < DoubleLanes<N>::kParts; ++i) result.part[i] = four;
    return result;
}

}  // namespace simd

// The largest of all lanes, in all lanes. No lane may be NaN.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> spread_largest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = simd::larger_halves(lanes.part[0]);
    for (int i = 1; i < DoubleLanes<N>::kParts; ++i) simd::take_larger(four, simd::larger_halves(lanes.part[i]));
    simd::take_larger(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_larger(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return simd::spread<N>(four);
}

// The smallest of all lanes, in all lanes. No lane may be NaN.
template <int N>
TUMBLE_LANE_FUNCTION DoubleLanes<N> spread_smallest(const DoubleLanes<N>& lanes) {
    simd::Double4 four = simd::smaller_halves(lanes.part[0]);
    for (int i = 1; i < DoubleLanes<N>::kParts; ++i) simd::take_smaller(four, simd::smaller_halves(lanes.part[i]));
    simd::take_smaller(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    simd::take_smaller(four, __builtin_shufflevector(four, four, 1, 0, 3, 2));
    return simd::spread<N>(four);
}

template <int N>
TUMBLE_LANE_FUNCTION double largest(const DoubleLanes<N>& lanes) {
    return first_lane(spread_largest(lanes));
}

template <int N>
TUMBLE_LANE_FUNCTION double smallest(const DoubleLanes<N>& lanes) {
    return first_lane(spread_smallest(lanes));
}

}  // namespace tumble
