// A random order of whole numbers that is not stored.
#pragma once

#include <cstdint>

namespace tumble::sweep {

// The number at `index` of a random order of 0 to `count` - 1: a Feistel network of four rounds over the next power of
// four, repeated until the number is below `count` (Black, Rogaway 2002, "Ciphers with arbitrary finite domains").
// Takes four repetitions on average at most.
std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t key);

}  // namespace tumble::sweep
