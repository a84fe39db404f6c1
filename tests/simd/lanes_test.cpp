// Lane helpers against one lane at a time in plain float.
#include "simd/lanes.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "simd/fma.hpp"
#include "simd/transpose.hpp"

using namespace tumble;

namespace {

Lanes random_lanes(std::mt19937& random) {
    std::uniform_real_distribution<float> value(-2.0f, 2.0f);
    Lanes lanes;
    for (int i = 0; i < kLaneCount; ++i) lanes[i] = value(random);
    return lanes;
}

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

}  // namespace

TEST_CASE("select_less chooses lane by lane, and the second value for NaN") {
    std::mt19937 random(1);
    int chosen = 0;
    for (int round = 0; round < 100; ++round) {
        Lanes a = random_lanes(random);
        const Lanes b = random_lanes(random), x = random_lanes(random), y = random_lanes(random);
        a[round % kLaneCount] = std::numeric_limits<float>::quiet_NaN();
        const Lanes result = select_less(a, b, x, y);
        for (int i = 0; i < kLaneCount; ++i) {
            CHECK(result[i] == (a[i] < b[i] ? x[i] : y[i]));
            chosen += a[i] < b[i];
        }
    }
    CHECK(chosen > 240);  // 30 to 70 % of 800
    CHECK(chosen < 560);
}

TEST_CASE("select_less takes equal values as not less") {
    const Lanes one = Lanes::Constant(1.0f), two = Lanes::Constant(2.0f), three = Lanes::Constant(3.0f);
    CHECK(select_less(one, one, two, three)[5] == 3.0f);
}

TEST_CASE("larger and smaller take the first of equal numbers and if one is NaN, on every processor") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float firsts[] = {0.0f, -0.0f, 3.0f, 1.0f, nan}, seconds[] = {-0.0f, 0.0f, 3.0f, nan, 1.0f};
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const Lanes first = Lanes::Constant(firsts[i]), second = Lanes::Constant(seconds[i]);
        CHECK(bits(larger(first, second)[6]) == bits(firsts[i]));
        CHECK(bits(smaller(first, second)[6]) == bits(firsts[i]));
    }
    const Lanes one = Lanes::Constant(1.0f), two = Lanes::Constant(2.0f);
    CHECK(larger(one, two)[3] == 2.0f);
    CHECK(larger(two, one)[3] == 2.0f);
    CHECK(smaller(one, two)[3] == 1.0f);
    CHECK(smaller(two, one)[3] == 1.0f);
}

TEST_CASE("square_root is that of each lane, correctly rounded") {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        const Lanes square = random_lanes(random).abs(), root = square_root(square);
        for (int i = 0; i < kLaneCount; ++i) CHECK(bits(root[i]) == bits(std::sqrt(square[i])));
    }
    for (const float special : {0.0f, -0.0f, 1e-45f, 3e-39f, std::numeric_limits<float>::infinity()})
        CHECK(bits(square_root(Lanes::Constant(special))[4]) == bits(std::sqrt(special)));
    CHECK(std::isnan(square_root(Lanes::Constant(-1.0f))[4]));
}

TEST_CASE("clamp_magnitude limits both signs") {
    std::mt19937 random(2);
    for (int round = 0; round < 50; ++round) {
        const Lanes value = random_lanes(random);
        const Lanes result = clamp_magnitude(value, Lanes::Constant(1.0f));
        for (int i = 0; i < kLaneCount; ++i) CHECK(result[i] == std::fmin(std::fmax(value[i], -1.0f), 1.0f));
    }
}

TEST_CASE("rows that are gathered into lanes and scattered again keep their bits") {
    alignas(32) float records[kLaneCount][8];
    for (int row = 0; row < kLaneCount; ++row)
        for (int field = 0; field < 8; ++field) records[row][field] = static_cast<float>(100 * row + field);
    const unsigned pattern = 0x7fa12345u;  // a signalling NaN: arithmetic would change it
    std::memcpy(&records[3][3], &pattern, sizeof pattern);
    // The rows are not in the order of memory.
    const int order[kLaneCount] = {5, 2, 7, 0, 3, 1, 6, 4};
    const float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) rows[lane] = records[order[lane]];
    Lanes fields[8];
    gather_rows(rows, fields);
    for (int lane = 0; lane < kLaneCount; ++lane)
        for (int field = 0; field < 8; ++field)
            CHECK(bits(fields[field].data()[lane]) == bits(records[order[lane]][field]));

    alignas(32) float copies[kLaneCount][8] = {};
    float* targets[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane) targets[lane] = copies[order[lane]];
    scatter_rows(fields[0], fields[1], fields[2], fields[3], targets);
    for (int row = 0; row < kLaneCount; ++row) {
        for (int field = 0; field < 4; ++field) CHECK(bits(copies[row][field]) == bits(records[row][field]));
        for (int field = 4; field < 8; ++field) CHECK(copies[row][field] == 0.0f);
    }
}

TEST_CASE("a difference of products survives cancellation") {
    // (1 + e)(1 - e) - 1 * 1 = -e^2, all lost in plain double arithmetic.
    const double e = 0x1p-30;
    CHECK((1 + e) * (1 - e) - 1.0 * 1.0 == 0.0);
    CHECK(difference_of_products(1 + e, 1 - e, 1.0, 1.0) == -e * e);
}

TEST_CASE("the fused multiply-add rounds once") {
    // 1 + 2^-12 squared is 1 + 2^-11 + 2^-24: the last term is below float's last place and lost by two roundings.
    const float a = 1.0f + 0x1p-12f;
    CHECK(fused_multiply_add(a, a, -1.0f) == 0x1p-11f + 0x1p-24f);
}
