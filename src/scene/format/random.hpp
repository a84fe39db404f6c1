// Random numbers that are the same on every platform: SplitMix64 (Steele, Lea, Flood 2014), an integer hash of a
// counter, mapped to doubles by its upper 53 bits.
#pragma once

#include <cstdint>

namespace tumble::scene {

class Random {
public:
    // Streams of one seed are independent.
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mix(seed) ^ mix(~stream)) {}

    std::uint64_t next() { return mix(state_ += kStep); }

    // In [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd

    static constexpr std::uint64_t mix(std::uint64_t z) {
        z += kStep;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

}  // namespace tumble::scene
