// Transposes records of floats into columns of double lanes: float i of record r becomes lane r of column i.
#pragma once

#include "simd/double_lanes.hpp"

namespace tumble {

namespace simd {

TUMBLE_LANE_FUNCTION Float4 load4(const float* values) {
    Float4 result;
    std::memcpy(&result, values, sizeof result);
    return result;
}

// Transposes four rows of four floats in place.
TUMBLE_LANE_FUNCTION void transpose(Float4 (&rows)[4]) {
    const Float4 low01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
                 low23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
    const Float4 high01 = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
                 high23 = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    rows[0] = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
    rows[1] = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    rows[2] = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
    rows[3] = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

}  // namespace simd

// Columns `from` to `from` + 3 of N records, widened to double. rows[N]: the records; columns: at least from + 4.
template <int N>
TUMBLE_LANE_FUNCTION void gather_columns(const float* const (&rows)[N], int from, DoubleLanes<N>* columns) {
    constexpr int kTiles = N / 4;
    simd::Float4 tiles[kTiles][4];
    for (int tile = 0; tile < kTiles; ++tile) {
        for (int row = 0; row < 4; ++row) tiles[tile][row] = simd::load4(rows[4 * tile + row] + from);
        simd::transpose(tiles[tile]);
    }
    for (int column = 0; column < 4; ++column) {
        for (int i = 0; i < DoubleLanes<N>::kParts; ++i) {
            if constexpr (DoubleLanes<N>::kWidth == 8)
                simd::widen(columns[from + column].part[i], tiles[2 * i][column], tiles[2 * i + 1][column]);
            else
                simd::widen(columns[from + column].part[i], tiles[i][column]);
        }
    }
}

}  // namespace tumble
