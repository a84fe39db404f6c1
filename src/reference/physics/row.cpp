#include "reference/physics/row.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "tumble/world.hpp"

namespace tumble::reference {

namespace {

// How far a value is from the exact one, or without one from the middle of a bar with two ends or the end of another.
double badness(const Finding& finding, double value) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    if (finding.exact) return std::abs(value - *finding.exact);
    if (!std::isfinite(finding.bar.lower)) return value;
    if (!std::isfinite(finding.bar.upper)) return -value;
    return std::abs(value - 0.5 * (finding.bar.lower + finding.bar.upper));
}

}  // namespace

Finding make_count(std::string condition, std::string quantity) {
    return {.condition = std::move(condition),
            .quantity = std::move(quantity),
            .unit = "",
            .exact = 0.0,
            .bar = at_most(0.0)};
}

double Finding::worst(Engine engine) const {
    const std::vector<double>& all = values[static_cast<std::size_t>(engine)];
    if (all.empty()) return std::numeric_limits<double>::quiet_NaN();
    return *std::ranges::max_element(all, {}, [&](double value) { return badness(*this, value); });
}

bool Finding::holds(Engine engine) const {
    const std::vector<double>& all = values[static_cast<std::size_t>(engine)];
    const auto passes = [&](double value) { return value >= bar.lower && value <= bar.upper; };
    return !all.empty() && std::ranges::all_of(all, passes);
}

bool RowResult::holds(Engine engine) const {
    return failure.empty() && !findings.empty() &&
           std::ranges::all_of(findings, [&](const Finding& finding) { return finding.holds(engine); });
}

RowResult run_row(const PhysicsRow& row, const Effort& effort) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    RowResult result;
    try {
        row.measure(result, effort);
    } catch (const SimulationDiverged& error) {
        result.failure = error.what();
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
}

}  // namespace tumble::reference
