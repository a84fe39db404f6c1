// Points that fill a cube evenly: the Sobol sequence, with the direction numbers of Joe and Kuo (2008, new-joe-kuo-6).
#pragma once

#include <cstdint>

namespace tumble::sweep {

inline constexpr unsigned kMostSobolDimensions = 21;
inline constexpr int kSobolBits = 53;

// Coordinate `dimension` (from 0) of point `index` as a whole number below 2^53. Of the first 2^k points, each of the
// 2^k equal slices of a coordinate contains one. `index` is below 2^53.
std::uint64_t sobol_bits(std::uint64_t index, unsigned dimension);

}  // namespace tumble::sweep
