// One register of four or eight double lanes: the compilers' vector types, and intrinsics where those compile to slow
// code.
//
// Functions return wide registers in a parameter: without AVX clang rejects a wide register as a return value.
#pragma once

#include <cmath>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "simd/lane_function.hpp"

namespace tumble {

namespace simd {

using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Mask4 = long long __attribute__((vector_size(32)));  // all bits of a lane, or none

// The register for N lanes: eight lanes wide with AVX-512 if N allows it, else four.
template <int N>
struct Register {
    using Double = Double4;
    using Mask = Mask4;
    static constexpr int kWidth = 4;
};

#if defined(__AVX512F__)
using Double8 = double __attribute__((vector_size(64)));

template <int N>
requires(N % 8 == 0) struct Register<N> {
    using Double = Double8;
    using Mask = __mmask8;
    static constexpr int kWidth = 8;
};

// The masked forms with all lanes set: g++ 12 warns of undefined lanes in the unmasked intrinsics.
inline constexpr __mmask8 kAll = 0xff;

TUMBLE_LANE_FUNCTION void take_larger(Double8& a, const Double8& b) { a = _mm512_maskz_max_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION void take_smaller(Double8& a, const Double8& b) { a = _mm512_maskz_min_pd(kAll, a, b); }
TUMBLE_LANE_FUNCTION void take_less(__mmask8& mask, const Double8& a, const Double8& b) {
    mask = _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
TUMBLE_LANE_FUNCTION void take_equal(__mmask8& mask, const Double8& a, const Double8& b) {
    mask = _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ);
}
TUMBLE_LANE_FUNCTION unsigned bits_of(__mmask8 mask) { return mask; }
TUMBLE_LANE_FUNCTION void replace(Double8& where, __mmask8 mask, const Double8& by) {
    where = _mm512_mask_mov_pd(where, mask, by);
}
TUMBLE_LANE_FUNCTION void load_widened(Double8& part, const float* values) {
    part = _mm512_maskz_cvtps_pd(kAll, _mm256_loadu_ps(values));
}
TUMBLE_LANE_FUNCTION void widen(Double8& part, const Float4& low, const Float4& high) {
    part = _mm512_maskz_cvtps_pd(kAll, __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
}
TUMBLE_LANE_FUNCTION void store_narrowed(const Double8& part, float* values) {
    _mm256_storeu_ps(values, _mm512_maskz_cvtpd_ps(kAll, part));
}
TUMBLE_LANE_FUNCTION void take_root(Double8& part) { part = _mm512_maskz_sqrt_pd(kAll, part); }
TUMBLE_LANE_FUNCTION Double4 larger_halves(const Double8& part) {
    return _mm256_max_pd(__builtin_shufflevector(part, part, 0, 1, 2, 3),
                         __builtin_shufflevector(part, part, 4, 5, 6, 7));
}
TUMBLE_LANE_FUNCTION Double4 smaller_halves(const Double8& part) {
    return _mm256_min_pd(__builtin_shufflevector(part, part, 0, 1, 2, 3),
                         __builtin_shufflevector(part, part, 4, 5, 6, 7));
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

// Intrinsics, as for `a < b` g++ with AVX-512 uses a mask register and then expands it to the lanes that blending and
// bits_of() need.
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
    // Not `a == b`: g++ 12 at -O1 turns that into a wrong mask where `a < b` is needed too.
    mask = (a <= b) & (b <= a);
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

// The compilers' own conversion stores two halves and loads them as a whole, which waits for both stores.
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

TUMBLE_LANE_FUNCTION void store_narrowed(const Double4& part, float* values) {
#if defined(__AVX__)
    _mm_storeu_ps(values, _mm256_cvtpd_ps(part));
#else
    for (int lane = 0; lane < 4; ++lane) values[lane] = static_cast<float>(part[lane]);
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

}  // namespace tumble
