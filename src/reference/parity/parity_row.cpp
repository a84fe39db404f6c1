// Counts and merges parity results. Rows are merged in the order of the pairs, whichever thread compared them.
#include <algorithm>
#include <cmath>

#include "reference/parity/parity.hpp"

namespace tumble::reference {

namespace {

// A wrong overlap flag, which misses or invents a contact, is worse than any error of the distance.
bool is_worse(const ParityCase& a, const ParityCase& b) {
    if (a.box2d_wrong_flag != b.box2d_wrong_flag) return a.box2d_wrong_flag;
    return a.severity > b.severity;
}

template <class T>
void raise(T& largest, T value) {
    largest = std::max(largest, value);
}

}  // namespace

const char* to_string(ParityVerdict verdict) {
    switch (verdict) {
        case ParityVerdict::right: return "none";
        case ParityVerdict::ours_wrong: return "ours";
        case ParityVerdict::box2d_wrong: return "Box2D";
        case ParityVerdict::both_wrong: return "both";
        case ParityVerdict::ill_conditioned: return "ill-conditioned";
    }
    return "unknown";
}

void ErrorHistogram::add(double relative_error) {
    const double bin = std::floor(2.0 * (std::log10(relative_error) + 20.0));
    if (bin < 0.0) {
        ++counts.front();
    } else if (bin < kBins) {
        ++counts[static_cast<std::size_t>(bin)];
    } else {
        ++counts.back();
    }
}

double ErrorHistogram::lower_edge(int bin) { return std::pow(10.0, 0.5 * bin - 20.0); }

bool ParityRow::is_among_worst(bool wrong_flag, double severity) const {
    if (!(severity > 0.0)) return false;
    if (worst_box2d.size() < kKeptWorst) return true;
    const ParityCase& last = worst_box2d.back();
    if (wrong_flag != last.box2d_wrong_flag) return wrong_flag;
    return severity > last.severity;  // earlier pairs stay first among equals
}

void ParityRow::keep(ParityCase comparison) {
    if (is_among_worst(comparison.box2d_wrong_flag, comparison.severity)) {
        const auto position = std::ranges::upper_bound(worst_box2d, comparison, is_worse);
        worst_box2d.insert(position, comparison);
        if (worst_box2d.size() > kKeptWorst) worst_box2d.pop_back();
    }
    const bool is_failure =
        comparison.verdict == ParityVerdict::ours_wrong || comparison.verdict == ParityVerdict::both_wrong;
    if (is_failure && ours_failures.size() < kKeptFailures) ours_failures.push_back(std::move(comparison));
}

void ParityRow::merge(const ParityRow& later) {
    pairs += later.pairs;
    comparisons += later.comparisons;
    checked_exactly += later.checked_exactly;
    ours_wrong += later.ours_wrong;
    ours_witness_wrong += later.ours_witness_wrong;
    box2d_wrong += later.box2d_wrong;
    box2d_wrong_flag += later.box2d_wrong_flag;
    box2d_wrong_distance += later.box2d_wrong_distance;
    box2d_witness_wrong += later.box2d_witness_wrong;
    box2d_refused += later.box2d_refused;
    ill_conditioned += later.ill_conditioned;
    raise(max_error_ours_m, later.max_error_ours_m);
    raise(max_error_ours_units, later.max_error_ours_units);
    raise(max_error_box2d_m, later.max_error_box2d_m);
    raise(max_error_box2d_eps, later.max_error_box2d_eps);
    iterations_ours += later.iterations_ours;
    iterations_box2d += later.iterations_box2d;
    raise(max_iterations_ours, later.max_iterations_ours);
    raise(max_iterations_box2d, later.max_iterations_box2d);
    for (std::size_t bin = 0; bin < histogram_ours.counts.size(); ++bin) {
        histogram_ours.counts[bin] += later.histogram_ours.counts[bin];
        histogram_box2d.counts[bin] += later.histogram_box2d.counts[bin];
    }
    for (const ParityCase& comparison : later.ours_failures)
        if (ours_failures.size() < kKeptFailures) ours_failures.push_back(comparison);
    for (const ParityCase& comparison : later.worst_box2d) {
        if (!is_among_worst(comparison.box2d_wrong_flag, comparison.severity)) break;
        worst_box2d.insert(std::ranges::upper_bound(worst_box2d, comparison, is_worse), comparison);
        if (worst_box2d.size() > kKeptWorst) worst_box2d.pop_back();
    }
}

ParityRow ParityResult::total() const {
    ParityRow sum;
    sum.name = "total";
    for (const ParityRow& row : families) sum.merge(row);
    return sum;
}

bool ParityResult::passed() const {
    return std::ranges::all_of(families,
                               [](const ParityRow& row) { return row.ours_wrong + row.ours_witness_wrong == 0; });
}

}  // namespace tumble::reference
