// Counter-based random numbers for generators: any pair of a run can be made again from (seed, index) alone.
//
// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014) with a mapping to doubles of
// its own: the distributions of <random> differ between standard libraries. A caller that draws twice does so in two
// statements or in one braced list, because the order in which arguments and operands are evaluated is the compiler's
// choice.
#pragma once

#include <cmath>
#include <cstdint>

#include "debug/check.hpp"
#include "tumble/math.hpp"

namespace tumble::reference {

class Random {
public:
    Random(std::uint64_t seed, std::uint64_t index) : state_(mix(seed) + 0xd1342543de82ef95u * (index + 1)) {}

    std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15u); }
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    int integer(int low, int high) {  // both included
        TUMBLE_CHECK(low <= high);
        const auto count = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
        return low + static_cast<int>(bits() % count);
    }
    bool chance(double probability) { return uniform() < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }

    // In [2^e, 2^(e + 1)) for a random exponent e in [low, high].
    double magnitude(int low, int high) {
        const int exponent = integer(low, high);
        return std::ldexp(uniform(1.0, 2.0), exponent);
    }
    double signed_magnitude(int low, int high) {
        const double of_sign = sign();
        return of_sign * magnitude(low, high);
    }

    DVec2 direction() {  // unit up to rounding
        const SinCos v = sin_cos(uniform(-kPi, kPi));
        return {v.cos, v.sin};
    }
    DVec2 vector(int low, int high) {  // of a random magnitude() in a random direction
        const double along = magnitude(low, high);
        return along * direction();
    }
    Rotation rotation() { return make_rotation(uniform(-kPi, kPi)); }
    DVec2 point(double half_side) { return {uniform(-half_side, half_side), uniform(-half_side, half_side)}; }

private:
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

}  // namespace tumble::reference
