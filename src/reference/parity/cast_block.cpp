#include "reference/parity/cast_block.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

#include "reference/box2d/b2_types.hpp"
#include "reference/box2d_v3/v3_queries.hpp"
#include "reference/parity/cast_judge.hpp"

namespace tumble::reference {

namespace {

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

std::vector<std::optional<B2Cast>> query_opponent(const std::vector<CastQuery>& queries, Opponent opponent) {
    std::vector<std::optional<B2Cast>> answers;
    if (opponent == Opponent::box2d_v3) {
        for (const CastQuery& query : queries) answers.push_back(query_box2d_v3(query));
        return answers;
    }
    const std::scoped_lock lock(b2_query_lock);
    for (const CastQuery& query : queries) answers.push_back(query_box2d(query));
    return answers;
}

void add_ours(ParityRow& row, const CastQuery& query, const MotionOracle& oracle, const CastResult& ours,
              CastVerdict verdict, ParityCase failure) {
    row.iterations_ours += static_cast<std::uint64_t>(ours.iterations);
    row.max_iterations_ours = std::max(row.max_iterations_ours, static_cast<int>(ours.iterations));
    if (ours.status == CastStatus::hit) {
        const double error = std::abs(static_cast<double>(oracle.gap(ours.fraction)));
        row.max_error_ours_m = std::max(row.max_error_ours_m, error);
        row.max_error_ours_units = std::max(row.max_error_ours_units, error / error_unit(start_of(query)));
        row.histogram_ours.add(error / largest_coordinate_of(query));
    }
    if (!is_wrong(verdict)) return;
    ++row.ours_wrong;
    failure.query = start_of(query);
    failure.verdict = ParityVerdict::ours_wrong;
    failure.reason = to_string(verdict);
    row.keep(failure);
}

void add_box2d(ParityRow& row, const MotionOracle& oracle, const B2Cast& box2d, CastVerdict verdict, double size) {
    if (box2d.hits) {
        const double error = std::abs(static_cast<double>(oracle.gap(box2d.fraction)));
        row.max_error_box2d_m = std::max(row.max_error_box2d_m, error);
        row.max_error_box2d_eps = std::max(row.max_error_box2d_eps, error / (kFloatEpsilon * size));
        row.histogram_box2d.add(error / size);
    }
    if (!is_wrong(verdict)) return;
    ++row.box2d_wrong;
    ++(verdict == CastVerdict::missed ? row.box2d_wrong_flag : row.box2d_wrong_distance);
}

}  // namespace

ParityRow compare_cast_block(const CastFamily& family, std::uint64_t begin, std::uint64_t end,
                             const ParityOptions& options) {
    ParityRow row;
    row.name = family.name;
    std::vector<CastQuery> queries;
    for (std::uint64_t index = begin; index < end; ++index) queries.push_back(family.generate(options.seed, index));
    const std::vector<std::optional<B2Cast>> box2d = query_opponent(queries, options.opponent);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const CastQuery& query = queries[i];
        const MotionOracle oracle(query);
        const CastResult ours = query_tumble(query);
        const CastVerdict verdict = judge(oracle, ours);
        ++row.pairs;
        ++row.comparisons;
        ++row.checked_exactly;
        ParityCase failure;
        failure.family = family.name;
        failure.seed = options.seed;
        failure.index = begin + i;
        add_ours(row, query, oracle, ours, verdict, failure);
        if (!box2d[i]) {
            ++row.box2d_refused;
            if (verdict == CastVerdict::graze) ++row.ill_conditioned;
            continue;
        }
        const double size = largest_coordinate_of(query);
        const CastVerdict theirs =
            judge(oracle, *box2d[i], box2d[i]->tolerance + kParityTolerance * kFloatEpsilon * size);
        add_box2d(row, oracle, *box2d[i], theirs, size);
        const bool differs = (ours.status == CastStatus::hit) != box2d[i]->hits;
        if ((verdict == CastVerdict::graze || differs) && !is_wrong(verdict) && !is_wrong(theirs))
            ++row.ill_conditioned;
    }
    return row;
}

}  // namespace tumble::reference
