// The judge of one comparison: both engines' answers to one query, blamed by exact arithmetic where it is asked for.
#pragma once

#include <optional>

#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/parity.hpp"

namespace tumble::reference {

// The exact side of a query: its distance, or, for large cores, the bounds that a certificate has proved.
class ExactSide {
public:
    static ExactSide of_distance(ExactDistance exact);
    static ExactSide of_certificate(const PairQuery& query, const DistanceResult& ours);

    bool is_exact() const { return exact_.has_value(); }
    bool ours_is_wrong(const DistanceResult& ours) const;
    int sign() const;      // of the exact signed distance; 0 also if the proved bounds straddle 0
    double value() const;  // the exact signed distance, or the middle of the bounds
    double error_of(double signed_distance) const;   // the absolute difference from it, or from the nearer bound
    double error_of_clamped(double distance) const;  // the same for a distance that is 0 inside
    bool has_unique_pair() const { return exact_ && exact_->has_unique_pair(); }

private:
    std::optional<ExactDistance> exact_;
    double lower_ = 0.0, upper_ = 0.0;  // proved, if there is no exact_
    bool proved_ = false;
};

struct Comparison {
    const PairQuery& query;
    const DistanceResult& ours;
    const std::optional<B2Distance>& box2d;
};

// True if the engines differ by more than the tolerance, or an answer contradicts itself: the exact side must decide.
bool needs_exact_check(const Comparison& comparison);

// Adds the comparison to the row; `exact` may be null if no check is needed. `id` names the pair in cases kept.
struct CaseId {
    std::uint64_t seed = 0;
    std::uint64_t index = 0;
};
void add_comparison(ParityRow& row, const Comparison& comparison, const ExactSide* exact, CaseId id);

// For input that must be refused: ours is wrong if it answers.
void add_invalid_comparison(ParityRow& row, const PairQuery& query, const DistanceResult& ours, CaseId id);

}  // namespace tumble::reference
