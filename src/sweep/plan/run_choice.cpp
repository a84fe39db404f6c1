// The values of one run: its place on the grid, and the numbers that are drawn for it.
#ifndef __clang_analyzer__
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scene/expressions/exponential.hpp"
#include "scene/format/random.hpp"
#include "scene/json/json_text.hpp"
#include "sweep/plan/permutation.hpp"
#include "sweep/plan/plan.hpp"
#include "sweep/plan/quantile.hpp"
#include "sweep/plan/sobol.hpp"

namespace tumble::sweep {

namespace {

// For the quantiles of 0 and 1, which are infinite.
constexpr double kSmallestUnit = 0x1p-54, kLargestUnit = 1.0 - 0x1p-53;

// Of the shifts of a Sobol sequence: no run has this number.
constexpr std::uint64_t kShiftStream = ~std::uint64_t{0};

// The seed of all numbers that are drawn for one name.
std::uint64_t key_of(const Plan& plan, std::string_view name) { return XXH64(name.data(), name.size(), plan.seed); }

// A number in [0, 1) for a drawn parameter; `dimension` counts those before it.
double unit_of(const Plan& plan, const Parameter& parameter, unsigned dimension, std::uint64_t run) {
    const std::uint64_t key = key_of(plan, parameter.name);
    scene::Random random(key, run);
    if (plan.sampling == Sampling::random) return random.unit();
    if (plan.sampling == Sampling::sobol) {
        // Adding a random number to all points, digit by digit, keeps their slices and avoids the corner 0.
        const std::uint64_t shift = scene::Random(key, kShiftStream).next() >> (64 - kSobolBits);
        return static_cast<double>(sobol_bits(run, dimension) ^ shift) * 0x1p-53;
    }
    const std::uint64_t slice = permuted(run % plan.slices, plan.slices, key + run / plan.slices);
    return (static_cast<double>(slice) + random.unit()) / static_cast<double>(plan.slices);
}

// The value of a range or of a normal distribution at `u` in [0, 1].
double value_at(Parameter::Kind kind, double lower, double upper, double u) {
    if (kind == Parameter::Kind::normal)
        return lower + upper * normal_quantile(std::clamp(u, kSmallestUnit, kLargestUnit));
    if (kind == Parameter::Kind::log_range && u > 0.0 && u < 1.0)
        return std::clamp(lower * scene::exponential(u * (natural_logarithm(upper) - natural_logarithm(lower))), lower,
                          upper);
    return u == 1.0 ? upper : lower + u * (upper - lower);
}

// A whole number stands for all numbers from itself to the next.
double drawn_value(const Parameter& parameter, double u) {
    if (!parameter.whole) return value_at(parameter.kind, parameter.lower, parameter.upper, u);
    const double value = value_at(parameter.kind, parameter.lower, parameter.upper + 1.0, u);
    return std::clamp(std::floor(value), parameter.lower, parameter.upper);
}

double grid_value(const Parameter& parameter, std::uint64_t index) {
    const double u = parameter.count < 2 ? 0.0 : static_cast<double>(index) / static_cast<double>(parameter.count - 1);
    const double value = value_at(parameter.kind, parameter.lower, parameter.upper, u);
    return parameter.whole ? std::floor(value + 0.5) : value;
}

std::string value_of(const Plan& plan, const Parameter& parameter, unsigned dimension, std::uint64_t run) {
    const double u = unit_of(plan, parameter, dimension, run);
    if (parameter.kind != Parameter::Kind::choice) return scene::number_text(drawn_value(parameter, u) + 0.0);
    const auto index = static_cast<std::size_t>(u * static_cast<double>(parameter.values.size()));
    return parameter.values[std::min(index, parameter.values.size() - 1)];
}

std::uint64_t seed_at(const Plan& plan, std::uint64_t run, std::uint64_t place) {
    if (plan.seeds.is_drawn) return scene::Random(key_of(plan, "/world/seed"), run).next() >> 11;
    return plan.seeds.list.empty() ? plan.seeds.first + place : plan.seeds.list[place];
}

}  // namespace

std::filesystem::path scene_file(const Plan& plan, std::size_t scene) {
    return (plan.file.parent_path() / plan.scenes.at(scene)).lexically_normal();
}

std::uint64_t grid_size(const Plan& plan) {
    std::uint64_t size = plan.scenes.size() * plan.seeds.grid_size();
    for (const Parameter& parameter : plan.parameters)
        if (parameter.is_on_grid()) size *= parameter.grid_size();
    return size;
}

std::uint64_t runs_in_shard(const Plan& plan) {
    constexpr std::uint64_t kShards = 60, kLeast = 1, kMost = 2000;
    if (plan.shard_runs > 0) return plan.shard_runs;
    return std::clamp<std::uint64_t>((plan.runs + kShards - 1) / kShards, kLeast, kMost);
}

std::uint64_t shard_count(const Plan& plan) {
    const std::uint64_t size = runs_in_shard(plan);
    return (plan.runs + size - 1) / size;
}

RunChoice choose_run(const Plan& plan, std::uint64_t run) {
    RunChoice choice{.run = run, .values = std::vector<std::string>(plan.parameters.size())};
    // The last parameter of the grid changes fastest.
    std::uint64_t place = run % grid_size(plan);
    for (std::size_t i = plan.parameters.size(); i-- > 0;) {
        const Parameter& parameter = plan.parameters[i];
        if (!parameter.is_on_grid()) continue;
        const std::uint64_t index = place % parameter.grid_size();
        place /= parameter.grid_size();
        choice.values[i] = parameter.kind == Parameter::Kind::list
                               ? parameter.values[index]
                               : scene::number_text(grid_value(parameter, index) + 0.0);
    }
    choice.seed = seed_at(plan, run, place % plan.seeds.grid_size());
    choice.scene = static_cast<std::size_t>(place / plan.seeds.grid_size());
    unsigned dimension = 0;
    for (std::size_t i = 0; i < plan.parameters.size(); ++i)
        if (!plan.parameters[i].is_on_grid()) choice.values[i] = value_of(plan, plan.parameters[i], dimension++, run);
    return choice;
}

std::vector<std::string> overrides_of(const Plan& plan, const RunChoice& choice) {
    std::vector<std::string> overrides = plan.settings;
    for (std::size_t i = 0; i < plan.parameters.size(); ++i)
        for (const std::string& pointer : plan.parameters[i].pointers)
            overrides.push_back(pointer + "=" + choice.values[i]);
    return overrides;
}

}  // namespace tumble::sweep
