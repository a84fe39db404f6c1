// Judges both engines' answers to a query by exact arithmetic.
#pragma once

#include <optional>

#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/parity.hpp"

namespace tumble::reference {

// The ground truth of a query: the exact distance or, for large cores, the bounds that the certificate proves.
class GroundTruth {
public:
    static GroundTruth of_distance(ExactDistance exact);
    static GroundTruth of_certificate(const PairQuery& query, const DistanceResult& ours);

    bool is_exact() const { return exact_.has_value(); }
    bool ours_is_wrong(const DistanceResult& ours) const;
    int sign() const;      // of the exact signed distance; 0 also if 0 is between the proved bounds
    double value() const;  // the exact signed distance, or the middle of the bounds
    double error_of(double signed_distance) const;   // absolute, from the exact distance or the nearer bound
    double error_of_clamped(double distance) const;  // the same for a distance that is 0 for overlap
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

// True if the engines differ by more than the tolerance or tumble's answer is inconsistent: the ground truth must
// decide.
bool needs_exact_check(const Comparison& comparison);

// Identifies a pair in the cases that a row keeps.
struct CaseId {
    std::uint64_t seed = 0;
    std::uint64_t index = 0;
};

// Adds the comparison to the row. `exact` may be null if no exact check is needed.
void add_comparison(ParityRow& row, const Comparison& comparison, const GroundTruth* exact, CaseId id);

// For invalid input: tumble's answer is wrong unless its status is `invalid`.
void add_invalid_comparison(ParityRow& row, const PairQuery& query, const DistanceResult& ours, CaseId id);

}  // namespace tumble::reference
