// Random numbers that a test draws, the same in each run.
#pragma once

#include <cstddef>
#include <random>

#include "tumble/math.hpp"

namespace tumble::test {

class RandomNumbers {
public:
    explicit RandomNumbers(unsigned seed) : random_(seed) {}

    float between(float lower, float upper) { return std::uniform_real_distribution<float>(lower, upper)(random_); }
    Vec2 vector(float size) { return {between(-size, size), between(-size, size)}; }
    bool coin() { return (random_() & 1u) != 0; }
    bool chance(float probability) { return between(0.0f, 1.0f) < probability; }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

private:
    std::mt19937 random_;
};

}  // namespace tumble::test
