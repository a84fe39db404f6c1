#include "sweep/plan/sobol.hpp"

#include <array>

namespace tumble::sweep {

namespace {

// A primitive polynomial over GF(2), x^degree + ... + 1, and the first direction numbers.
struct Polynomial {
    int degree;
    unsigned coefficients;  // of x^(degree-1) to x, the highest first
    std::array<unsigned, 7> first;
};

// Dimensions 2 to 21.
constexpr std::array<Polynomial, kMostSobolDimensions - 1> kPolynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

using Directions = std::array<std::uint64_t, kSobolBits>;

// The direction numbers as binary fractions: number k has its highest bit at place k + 1 after the point.
constexpr Directions directions_of(unsigned dimension) {
    Directions result{};
    const auto shifted = [](std::uint64_t number, int k) { return number << (kSobolBits - 1 - k); };
    if (dimension == 0) {
        for (int k = 0; k < kSobolBits; ++k) result[static_cast<std::size_t>(k)] = shifted(1, k);
        return result;
    }
    const Polynomial& polynomial = kPolynomials[dimension - 1];
    const int degree = polynomial.degree;
    for (int k = 0; k < kSobolBits; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (k < degree) {
            result[at] = shifted(polynomial.first[at], k);
            continue;
        }
        const std::uint64_t oldest = result[at - static_cast<std::size_t>(degree)];
        result[at] = oldest ^ (oldest >> degree);
        for (int j = 1; j < degree; ++j)
            if ((polynomial.coefficients >> (degree - 1 - j)) & 1u)
                result[at] ^= result[at - static_cast<std::size_t>(j)];
    }
    return result;
}

constexpr std::array<Directions, kMostSobolDimensions> all_directions() {
    std::array<Directions, kMostSobolDimensions> all{};
    for (unsigned dimension = 0; dimension < kMostSobolDimensions; ++dimension)
        all[dimension] = directions_of(dimension);
    return all;
}

constexpr std::array<Directions, kMostSobolDimensions> kDirections = all_directions();

}  // namespace

std::uint64_t sobol_bits(std::uint64_t index, unsigned dimension) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; index >> k != 0; ++k)
        if ((index >> k) & 1u) bits ^= kDirections[dimension][k];
    return bits;
}

}  // namespace tumble::sweep
