// Double lanes against one lane at a time.
#include "simd/double_lanes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using namespace tumble;

namespace {

template <int N>
struct Numbers {
    double value[N];

    // Few different values, so that lanes are often equal.
    explicit Numbers(std::mt19937& random) {
        std::uniform_int_distribution<int> any(-2, 2);
        for (double& number : value) number = any(random);
    }
    DoubleLanes<N> lanes() const {
        DoubleLanes<N> result(0.0);
        std::memcpy(result.part, value, sizeof value);
        return result;
    }
};

template <int N>
int check_all_operations() {
    std::mt19937 random(N);
    int ties = 0;
    for (int round = 0; round < 1000; ++round) {
        const Numbers<N> a(random), b(random);
        const DoubleLanes<N> x = a.lanes(), y = b.lanes();
        const DoubleLanes<N> sum = x + y, difference = x - y, product = x * y, quotient = x / y,
                             root = square_root(x * x);
        const DoubleLanes<N> minimum = smaller(x, y), maximum = larger(x, y), next = next_lanes(x),
                             third = spread<2>(x);
        const DoubleLanes<N> chosen = select(x < y, y, DoubleLanes<N>(7.0)), negative = -x;
        const MaskLanes<N> is_less = x < y, is_equal = x == y;
        LowestLanes<N> lowest{x};
        take_lower(lowest, y, 5);
        double largest_value = a.value[0], smallest_value = a.value[0];
        unsigned equal = 0;
        for (int i = 0; i < N; ++i) {
            const double p = a.value[i], q = b.value[i];
            CHECK(sum[i] == p + q);
            CHECK(difference[i] == p - q);
            CHECK(product[i] == p * q);
            if (q != 0.0) CHECK(quotient[i] == p / q);
            CHECK(root[i] == std::abs(p));
            CHECK(minimum[i] == std::min(p, q));
            CHECK(maximum[i] == std::max(p, q));
            CHECK(next[i] == a.value[(i + 1) % N]);
            CHECK(third[i] == a.value[2]);
            CHECK(chosen[i] == (p < q ? q : 7.0));
            CHECK(negative[i] == -p);
            CHECK((bits_of(is_less) >> i & 1u) == (p < q));
            CHECK((bits_of(is_equal) >> i & 1u) == (p == q));
            CHECK((bits_of(is_less | is_equal) >> i & 1u) == (p <= q));
            CHECK((bits_of(~is_less & ~is_equal) >> i & 1u) == (p > q));
            CHECK(lowest.value[i] == std::min(p, q));
            CHECK(lowest.index[i] == (q < p ? 5 : 0));
            largest_value = std::max(largest_value, p);
            smallest_value = std::min(smallest_value, p);
        }
        CHECK(largest(x) == largest_value);
        CHECK(smallest(x) == smallest_value);
        for (int i = 0; i < N; ++i) equal |= static_cast<unsigned>(a.value[i] == largest_value) << i;
        CHECK(bits_of(x == DoubleLanes<N>(largest_value)) == equal);
        ties += std::popcount(equal) > 1;
    }
    return ties;
}

}  // namespace

TEST_CASE("every operation on lanes has the results of the scalar operation") {
    for (const int ties : {check_all_operations<4>(), check_all_operations<8>()}) {
        CHECK(ties > 300);
        CHECK(ties < 900);
    }
}

TEST_CASE("lanes compare like scalars: NaN is neither less nor equal, and -0 equals 0") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const DoubleLanes<4> chosen =
        select(DoubleLanes<4>(0.0) < DoubleLanes<4>(nan), DoubleLanes<4>(1.0), DoubleLanes<4>(-inf));
    CHECK(chosen[3] == -inf);
    CHECK(bits_of(chosen == DoubleLanes<4>(largest(chosen))) == 0xf);
    CHECK(bits_of(DoubleLanes<8>(nan) == DoubleLanes<8>(nan)) == 0);
    CHECK(bits_of(DoubleLanes<8>(nan) < DoubleLanes<8>(1.0)) == 0);
    CHECK(bits_of(DoubleLanes<8>(-0.0) < DoubleLanes<8>(0.0)) == 0);
    CHECK(bits_of(~(DoubleLanes<8>(nan) < DoubleLanes<8>(1.0))) == 0xff);
}

TEST_CASE("floats are widened without change, denormal ones too") {
    const float values[8] = {1.0f, -0.1f, 0x1p-149f, 0.0f, -0.0f, 3e38f, -7.5f, 1e-20f};
    const DoubleLanes<8> wide = load_widened<8>(values);
    for (int i = 0; i < 8; ++i) CHECK(wide[i] == static_cast<double>(values[i]));
    const DoubleLanes<4> half = load_widened<4>(values + 3);
    for (int i = 0; i < 4; ++i) CHECK(half[i] == static_cast<double>(values[3 + i]));
}

TEST_CASE("lanes are rounded to floats as scalars are") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    // Two ties, which round to even, numbers that become denormal or 0, one that is too large, and -0.
    const double values[8] = {1.0 + 0x1p-24, 1.0 + 0x3p-24, 0x1.8p-149, 0x1p-151, 1e300, -0.0, 0.1, nan};
    const DoubleLanes<8> lanes = gather_lanes<8>([&](int i) { return values[i]; });
    float narrowed[8], half[4];
    store_narrowed(lanes, narrowed);
    store_narrowed(gather_lanes<4>([&](int i) { return values[i + 4]; }), half);
    for (int i = 0; i < 8; ++i) {
        CAPTURE(i);
        const float expected = static_cast<float>(values[i]);
        CHECK((narrowed[i] == expected || (std::isnan(narrowed[i]) && std::isnan(expected))));
        CHECK(std::signbit(narrowed[i]) == std::signbit(expected));
        if (i >= 4) CHECK(std::memcmp(&half[i - 4], &narrowed[i], sizeof(float)) == 0);
    }
}
