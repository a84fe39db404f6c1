#include "sweep/plan/permutation.hpp"

#include <bit>

#include "scene/format/random.hpp"

namespace tumble::sweep {

namespace {

constexpr std::uint64_t kRounds = 4;

std::uint64_t encrypted(std::uint64_t number, int half_bits, std::uint64_t key) {
    const std::uint64_t mask = (std::uint64_t{1} << half_bits) - 1;
    std::uint64_t left = number >> half_bits, right = number & mask;
    for (std::uint64_t round = 0; round < kRounds; ++round) {
        const std::uint64_t mixed = left ^ (scene::Random(key + round, right).next() & mask);
        left = right;
        right = mixed;
    }
    return left << half_bits | right;
}

}  // namespace

std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t key) {
    if (count < 2) return index;
    const int half_bits = (static_cast<int>(std::bit_width(count - 1)) + 1) / 2;
    do index = encrypted(index, half_bits, key);
    while (index >= count);
    return index;
}

}  // namespace tumble::sweep
