// Rows of floats to columns of double lanes: record r's number i becomes lane r of column i.
#pragma once

#include "simd/double_lanes.hpp"

namespace tumble {

namespace simd {

using Float4 = float __attribute__((vector_size(16)));

TUMBLE_LANE_FUNCTION Float4 load4(const float* values) {
    Float4 result;
    std::memcpy(&result, values, sizeof result);
    return result;
}

TUMBLE_LANE_FUNCTION void store4(float* values, const Float4& from) { std::memcpy(values, &from, sizeof from); }

}  // namespace simd

// Columns from to from + 3 of N records, widened: four floats at each of `rows`.
template <int N>
TUMBLE_LANE_FUNCTION void gather_columns(const float* const (&rows)[N], int from, DoubleLanes<N>* columns) {
    using simd::Float4;
    alignas(32) float table[4][N];
    for (int row = 0; row < N; row += 4) {
        const Float4 r0 = simd::load4(rows[row] + from), r1 = simd::load4(rows[row + 1] + from),
                     r2 = simd::load4(rows[row + 2] + from), r3 = simd::load4(rows[row + 3] + from);
        const Float4 low01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5), low23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
        const Float4 high01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7), high23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
        simd::store4(table[0] + row, __builtin_shufflevector(low01, low23, 0, 1, 4, 5));
        simd::store4(table[1] + row, __builtin_shufflevector(low01, low23, 2, 3, 6, 7));
        simd::store4(table[2] + row, __builtin_shufflevector(high01, high23, 0, 1, 4, 5));
        simd::store4(table[3] + row, __builtin_shufflevector(high01, high23, 2, 3, 6, 7));
    }
    for (int column = 0; column < 4; ++column) columns[from + column] = load_widened<N>(table[column]);
}

}  // namespace tumble
