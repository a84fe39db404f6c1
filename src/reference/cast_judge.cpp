#include "reference/cast_judge.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "reference/cast_families.hpp"

namespace tumble::reference {

namespace {

using Real = brute::Real;

// What the long double arithmetic of the truth may itself be wrong by, in E: 2^-11 of it, with a margin.
constexpr Real kOwnError = 1.0L / 256;

// The bracket must hold the first contact; where the motion never goes clearly below the target it may be found or not.
CastVerdict judge_straight_bracket(const TrueMotion& truth, const CastResult& hit) {
    const Real slack = kOwnError * (hit.upper - hit.lower);
    const std::optional<Real> first = truth.first_contact();
    if (first && hit.lower - slack <= *first && *first <= hit.upper + slack) return CastVerdict::hit;
    return truth.stays_above(-4 * truth.error(), 0, 1) ? CastVerdict::graze : CastVerdict::bracket;
}

CastVerdict judge_miss(const TrueMotion& truth, Real floor, Real clear) {
    if (!truth.stays_above(floor, 0, 1)) return CastVerdict::missed;
    return truth.gap(0) >= clear && truth.stays_above(clear, 0, 1) ? CastVerdict::miss : CastVerdict::graze;
}

bool is_ordered(const CastResult& hit) {
    return hit.lower <= hit.fraction && hit.fraction <= hit.upper && 0.0 <= hit.fraction && hit.fraction <= 1.0 &&
           std::abs(length(hit.normal) - 1.0) < 1e-15;
}

double largest_coordinate_of(const CastQuery& query) {
    PairQuery start = start_of(query), end = start;
    if (query.kind == CastKind::impact) {
        end.pose_a.position = query.sweep_a.end;
        end.pose_b.position = query.sweep_b.end;
    } else {
        end.pose_b.position += query.translation;
    }
    return std::max(largest_coordinate(start), largest_coordinate(end));
}

std::vector<std::optional<B2Cast>> ask_all_box2d(const std::vector<CastQuery>& queries) {
    static std::mutex one_thread;  // it counts its calls in plain globals
    const std::scoped_lock lock(one_thread);
    std::vector<std::optional<B2Cast>> answers;
    for (const CastQuery& query : queries) answers.push_back(ask_box2d(query));
    return answers;
}

void add_ours(ParityRow& row, const CastQuery& query, const TrueMotion& truth, const CastResult& ours,
              CastVerdict verdict, ParityCase failure) {
    row.iterations_ours += static_cast<std::uint64_t>(ours.iterations);
    row.max_iterations_ours = std::max(row.max_iterations_ours, static_cast<int>(ours.iterations));
    if (ours.status == CastStatus::hit) {
        const double error = std::abs(static_cast<double>(truth.gap(ours.fraction)));
        row.max_error_ours_m = std::max(row.max_error_ours_m, error);
        row.max_error_ours_units = std::max(row.max_error_ours_units, error / error_unit(start_of(query)));
        row.histogram_ours.add(error / largest_coordinate_of(query));
    }
    if (!is_wrong(verdict)) return;
    ++row.ours_wrong;
    failure.query = start_of(query);
    failure.culprit = Culprit::ours;
    failure.reason = to_string(verdict);
    row.keep(failure);
}

void add_box2d(ParityRow& row, const TrueMotion& truth, const B2Cast& box2d, CastVerdict verdict, double size) {
    if (box2d.hits) {
        const double error = std::abs(static_cast<double>(truth.gap(box2d.fraction)));
        row.max_error_box2d_m = std::max(row.max_error_box2d_m, error);
        row.max_error_box2d_eps = std::max(row.max_error_box2d_eps, error / (kFloatEpsilon * size));
        row.histogram_box2d.add(error / size);
    }
    if (!is_wrong(verdict)) return;
    ++row.box2d_wrong;
    ++(verdict == CastVerdict::missed ? row.box2d_wrong_flag : row.box2d_wrong_distance);
}

}  // namespace

const char* to_string(CastVerdict verdict) {
    switch (verdict) {
        case CastVerdict::hit:
            return "hit";
        case CastVerdict::miss:
            return "miss";
        case CastVerdict::overlap:
            return "overlap";
        case CastVerdict::graze:
            return "graze";
        case CastVerdict::missed:
            return "a missed hit";
        case CastVerdict::false_hit:
            return "a false hit";
        case CastVerdict::bracket:
            return "the bracket";
        case CastVerdict::refused:
            return "no answer";
    }
    return "unknown";
}

CastVerdict judge(const TrueMotion& truth, const CastResult& ours) {
    const Real error = truth.error(), own = kOwnError * error;
    switch (ours.status) {
        case CastStatus::invalid:
            return CastVerdict::refused;
        case CastStatus::overlapping:
            return truth.gap(0) < own ? CastVerdict::overlap : CastVerdict::false_hit;
        case CastStatus::miss:
            return judge_miss(truth, -4 * error, own);
        case CastStatus::hit:
            break;
    }
    if (!is_ordered(ours)) return CastVerdict::bracket;
    const Real lower = std::max(0.0, ours.lower), upper = ours.upper;
    if (!truth.stays_above(-4 * error, 0, lower)) return CastVerdict::missed;
    if (!(std::abs(truth.gap(ours.fraction)) <= 4 * error)) return CastVerdict::false_hit;
    if (truth.is_straight() && lower > 0) return judge_straight_bracket(truth, ours);
    if (truth.gap(upper) > own)  // nothing is passed: only a touch that goes no deeper may be answered so
        return truth.gap(std::min(upper, Real{1})) <= 4 * error ? CastVerdict::graze : CastVerdict::bracket;
    return lower == 0 || truth.stays_above(-own, 0, lower) ? CastVerdict::hit : CastVerdict::graze;
}

CastVerdict judge(const TrueMotion& truth, const B2Cast& box2d, double tolerance) {
    if (box2d.overlaps) return truth.gap(0) < tolerance ? CastVerdict::overlap : CastVerdict::false_hit;
    if (!box2d.hits && truth.gap(0) < tolerance) return CastVerdict::graze;  // it calls a start at the target a miss
    if (!box2d.hits) return judge_miss(truth, -tolerance, 0);
    if (box2d.fraction > 0.0 && !truth.stays_above(-tolerance, 0, box2d.fraction)) return CastVerdict::missed;
    return truth.gap(box2d.fraction) <= tolerance ? CastVerdict::hit : CastVerdict::false_hit;
}

ParityRow compare_cast_block(const CastFamily& family, std::uint64_t begin, std::uint64_t end,
                             const ParityOptions& options) {
    ParityRow row;
    row.name = family.name;
    std::vector<CastQuery> queries;
    for (std::uint64_t index = begin; index < end; ++index) queries.push_back(family.generate(options.seed, index));
    const std::vector<std::optional<B2Cast>> box2d = ask_all_box2d(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const CastQuery& query = queries[i];
        const TrueMotion truth(query);
        const CastResult ours = ask_tumble(query);
        const CastVerdict verdict = judge(truth, ours);
        ++row.pairs;
        ++row.comparisons;
        ++row.checked_exactly;
        ParityCase failure;
        failure.family = family.name;
        failure.seed = options.seed;
        failure.index = begin + i;
        add_ours(row, query, truth, ours, verdict, failure);
        if (!box2d[i]) {
            ++row.box2d_refused;
            if (verdict == CastVerdict::graze) ++row.ill_conditioned;
            continue;
        }
        const double size = largest_coordinate_of(query);
        const CastVerdict theirs =
            judge(truth, *box2d[i], box2d[i]->tolerance + kParityTolerance * kFloatEpsilon * size);
        add_box2d(row, truth, *box2d[i], theirs, size);
        const bool differs = (ours.status == CastStatus::hit) != box2d[i]->hits;
        if ((verdict == CastVerdict::graze || differs) && !is_wrong(verdict) && !is_wrong(theirs))
            ++row.ill_conditioned;
    }
    return row;
}

}  // namespace tumble::reference
