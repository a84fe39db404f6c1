// The numbers that a plan draws.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "sweep/plan/permutation.hpp"
#include "sweep/plan/plan.hpp"
#include "sweep/plan/quantile.hpp"
#include "sweep/plan/sobol.hpp"

using namespace tumble::sweep;

TEST_CASE("the logarithm agrees with that of the system to 4 units of the last place") {
    int checked = 0;
    for (double x = 1e-12; x < 1e12; x *= 1.37, ++checked) {
        const double exact = std::log(x), difference = std::abs(natural_logarithm(x) - exact);
        CAPTURE(x);
        // Near 1 the parts of the exponent and of the fraction cancel: 1 ulp of ln 2 remains.
        CHECK(difference <= 4 * 0x1p-53 * std::max(std::abs(exact), 0.7));
    }
    CHECK(checked > 100);
    CHECK(natural_logarithm(1.0) == 0.0);
}

TEST_CASE("quantiles of the normal distribution are those of tables") {
    CHECK(std::abs(normal_quantile(0.5)) < 1e-14);
    // Abramowitz and Stegun, table 26.5; and the tail by erfc.
    CHECK(std::abs(normal_quantile(0.975) - 1.959963984540054) < 1e-12);
    CHECK(std::abs(normal_quantile(0.8413447460685429) - 1.0) < 1e-12);
    for (const double u : {1e-6, 0.01, 0.2, 0.7, 0.999}) {
        const double x = normal_quantile(u);
        CHECK(std::abs(0.5 * std::erfc(-x / std::sqrt(2.0)) - u) < 2e-15);
    }
}

TEST_CASE("a permutation has each number once, and another order for another key") {
    for (const std::uint64_t count : {1ull, 2ull, 3ull, 16ull, 17ull, 1000ull}) {
        std::set<std::uint64_t> seen;
        bool differs = false;
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::uint64_t place = permuted(i, count, 7);
            CHECK(place < count);
            seen.insert(place);
            differs = differs || place != permuted(i, count, 8);
        }
        CHECK(seen.size() == count);
        CHECK(differs == (count > 2 ? true : differs));
    }
    CHECK(permuted(123456789, 1000000000000, 1) < 1000000000000);
}

TEST_CASE("each slice of a coordinate has one of the first points of the Sobol sequence") {
    for (unsigned dimension = 0; dimension < kMostSobolDimensions; ++dimension)
        for (const int k : {1, 4, 7, 10}) {
            std::set<std::uint64_t> slices;
            for (std::uint64_t i = 0; i < (1ull << k); ++i) slices.insert(sobol_bits(i, dimension) >> (kSobolBits - k));
            CAPTURE(dimension);
            CHECK(slices.size() == (1ull << k));
        }
}

TEST_CASE("the first points of the Sobol sequence are those that are published") {
    // Joe and Kuo's program prints, for three dimensions and in the order of Gray codes: (0,0,0), (.5,.5,.5),
    // (.75,.25,.25), (.25,.75,.75), (.375,.375,.625). Its point n is the point n ^ (n >> 1) of ours.
    const double expected[5][3] = {{0, 0, 0}, {.5, .5, .5}, {.75, .25, .25}, {.25, .75, .75}, {.375, .375, .625}};
    for (std::uint64_t n = 0; n < 5; ++n)
        for (unsigned dimension = 0; dimension < 3; ++dimension)
            CHECK(static_cast<double>(sobol_bits(n ^ (n >> 1), dimension)) * 0x1p-53 == expected[n][dimension]);
}

namespace {

Plan plan_of(Sampling sampling, std::uint64_t runs) {
    Plan plan;
    plan.scenes = {"a.json"};
    plan.runs = plan.slices = runs;
    plan.sampling = sampling;
    plan.parameters = {{.name = "x", .pointers = {"/x"}, .kind = Parameter::Kind::range, .lower = 2.0, .upper = 6.0},
                       {.name = "y", .pointers = {"/y"}, .kind = Parameter::Kind::range, .lower = 0.0, .upper = 1.0}};
    return plan;
}

}  // namespace

TEST_CASE("a Latin hypercube and a Sobol sequence have one run in each slice of each parameter") {
    for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
        const Plan plan = plan_of(sampling, 64);
        for (std::size_t parameter = 0; parameter < 2; ++parameter) {
            std::set<int> slices;
            for (std::uint64_t run = 0; run < 64; ++run) {
                const double value = std::stod(choose_run(plan, run).values[parameter]);
                slices.insert(static_cast<int>(parameter == 0 ? (value - 2.0) * 16.0 : value * 64.0));
            }
            CHECK((slices.size() == 64) == (sampling != Sampling::random));
        }
    }
}

TEST_CASE("a run does not depend on how many runs there are, nor on other parameters") {
    Plan plan = plan_of(Sampling::latin_hypercube, 64);
    const RunChoice before = choose_run(plan, 40);
    plan.runs = 50;
    CHECK(choose_run(plan, 40).values == before.values);
    plan.parameters.erase(plan.parameters.begin());
    CHECK(choose_run(plan, 40).values[0] == before.values[1]);
    CHECK(choose_run(plan, 40).seed == before.seed);
    CHECK(choose_run(plan, 41).seed != before.seed);
}

TEST_CASE("a plan has at most 60 shards of at most 2000 runs unless it states how many runs a shard has") {
    const auto sizes_of = [](std::uint64_t runs, std::uint64_t stated = 0) {
        Plan plan;
        plan.runs = runs;
        plan.shard_runs = stated;
        return std::pair(runs_in_shard(plan), shard_count(plan));
    };
    using Sizes = std::pair<std::uint64_t, std::uint64_t>;
    CHECK(sizes_of(3) == Sizes{1, 3});
    CHECK(sizes_of(40) == Sizes{1, 40});
    CHECK(sizes_of(300) == Sizes{5, 60});
    CHECK(sizes_of(600) == Sizes{10, 60});
    CHECK(sizes_of(1'000'000) == Sizes{2000, 500});
    CHECK(sizes_of(40, 1) == Sizes{1, 40});
}

TEST_CASE("the grid has each combination once, and the last parameter changes fastest") {
    Plan plan;
    plan.scenes = {"a.json", "b.json"};
    plan.seeds = {.is_drawn = false, .list = {7, 8}};
    plan.parameters = {{.name = "x", .pointers = {"/x"}, .values = {"1", "\"two\""}},
                       {.name = "y",
                        .pointers = {"/y", "/z"},
                        .kind = Parameter::Kind::range,
                        .lower = 0.0,
                        .upper = 1.0,
                        .count = 3}};
    plan.runs = plan.slices = grid_size(plan);
    CHECK(plan.runs == 2 * 2 * 2 * 3);
    std::set<std::string> all;
    for (std::uint64_t run = 0; run < plan.runs; ++run) {
        const RunChoice choice = choose_run(plan, run);
        all.insert(std::to_string(choice.scene) + "/" + std::to_string(choice.seed) + choice.values[0] +
                   choice.values[1]);
    }
    CHECK(all.size() == plan.runs);
    CHECK(choose_run(plan, 1).values == std::vector<std::string>{"1", "0.5"});
    CHECK(choose_run(plan, 3).values == std::vector<std::string>{"\"two\"", "0"});
    CHECK(choose_run(plan, 6).seed == 8);
    CHECK(choose_run(plan, 12).scene == 1);
    CHECK(overrides_of(plan, choose_run(plan, 3)) == std::vector<std::string>{"/x=\"two\"", "/y=0", "/z=0"});
}

TEST_CASE("whole numbers, logarithmic ranges and normal numbers are distributed as stated") {
    Plan plan = plan_of(Sampling::random, 4000);
    plan.parameters = {
        {.name = "w", .pointers = {}, .kind = Parameter::Kind::range, .lower = 1.0, .upper = 6.0, .whole = true},
        {.name = "l", .pointers = {}, .kind = Parameter::Kind::log_range, .lower = 0.01, .upper = 100.0},
        {.name = "n", .pointers = {}, .kind = Parameter::Kind::normal, .lower = 10.0, .upper = 2.0},
        {.name = "c", .pointers = {}, .kind = Parameter::Kind::choice, .values = {"true", "false"}},
        {.name = "m", .pointers = {}, .kind = Parameter::Kind::log_range, .lower = 1.0, .upper = 1e6, .whole = true},
        {.name = "v", .pointers = {}, .kind = Parameter::Kind::log_range, .lower = 1e-300, .upper = 1e300}};
    int below_1000 = 0, below_1 = 0;
    int sixes = 0, below_one = 0, above_mean = 0, within = 0, truths = 0;
    for (std::uint64_t run = 0; run < 4000; ++run) {
        const RunChoice choice = choose_run(plan, run);
        sixes += choice.values[0] == "6";
        below_one += std::stod(choice.values[1]) < 1.0;
        above_mean += std::stod(choice.values[2]) > 10.0;
        within += std::abs(std::stod(choice.values[2]) - 10.0) < 2.0;
        truths += choice.values[3] == "true";
        below_1000 += std::stod(choice.values[4]) < 1000.0;
        CHECK(std::stod(choice.values[4]) == std::floor(std::stod(choice.values[4])));
        below_1 += std::stod(choice.values[5]) < 1.0;
    }
    // Binomial: four deviations, sqrt(4000 p (1 - p)).
    CHECK(std::abs(sixes - 667) < 95);
    CHECK(std::abs(below_one - 2000) < 127);
    CHECK(std::abs(above_mean - 2000) < 127);
    CHECK(std::abs(within - 2731) < 118);
    CHECK(std::abs(truths - 2000) < 127);
    CHECK(std::abs(below_1000 - 2000) < 127);
    CHECK(std::abs(below_1 - 2000) < 127);
}
