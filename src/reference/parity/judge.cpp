#include "reference/parity/judge.hpp"

#include <algorithm>
#include <cmath>

#include "reference/exact/certificate.hpp"
#include "reference/parity/witness.hpp"

namespace tumble::reference {

namespace {

// The error limits of tumble's answers. The core distance is within E = 16 u (RA + RB + |p|); subtracting the radii
// adds 4 u of all lengths. The bounds are E on either side, and the loop may stop with its bounds 2 E apart: for
// "touching", the distance may be that far from 0.
struct ErrorLimits {
    double distance = 0.0;
    double bounds = 0.0;
};

ErrorLimits error_limits_of(const PairQuery& query) {
    constexpr double kUnitRoundoff = 0x1p-53;
    const double radii = double{query.a.radius()} + query.b.radius(), scale = bound_scale(query);
    const double subtraction = 4.0 * (radii + scale);
    const double distance = 16.0 * scale + (radii > 0.0 ? subtraction : 0.0);
    return {kUnitRoundoff * distance, kUnitRoundoff * (64.0 * scale + 2.0 * subtraction)};
}

double tolerance(const PairQuery& query) { return kParityTolerance * kFloatEpsilon * largest_coordinate(query); }

bool exceeds(double error, double bound) { return !(error <= bound); }  // NaN exceeds every bound

bool reports_overlap(const B2Distance& answer) { return answer.distance == 0.0; }

bool contradicts(const B2Distance& answer, int exact_sign) {
    return (exact_sign > 0 && reports_overlap(answer)) || (exact_sign < 0 && !reports_overlap(answer));
}

bool contradicts(DistanceStatus status, int exact_sign) {
    switch (status) {
        case DistanceStatus::separated: return exact_sign <= 0;
        case DistanceStatus::overlapping: return exact_sign >= 0;
        case DistanceStatus::touching: return false;
        case DistanceStatus::invalid: break;
    }
    return true;
}

int sign_of(DistanceStatus status) {
    return status == DistanceStatus::separated ? 1 : status == DistanceStatus::overlapping ? -1 : 0;
}

// The error of Box2D relative to tumble's answer, which has eight more digits.
double clamped_difference(const Comparison& comparison) {
    return std::abs(comparison.box2d->distance - std::max(0.0, comparison.ours.distance));
}

// For overlapping radii both witness points of Box2D are the middle of the overlap, by design.
bool has_comparable_witness(const B2Distance& answer) { return !reports_overlap(answer); }

struct Findings {
    bool ours = false;
    bool box2d = false;
    bool box2d_flag = false;
    bool ill_conditioned = false;
    std::string reason;

    ParityVerdict verdict() const {
        if (ours) return box2d ? ParityVerdict::both_wrong : ParityVerdict::ours_wrong;
        return box2d             ? ParityVerdict::box2d_wrong
               : ill_conditioned ? ParityVerdict::ill_conditioned
                                 : ParityVerdict::right;
    }
    void add_reason(const char* text) { reason += reason.empty() ? text : std::string(", ") + text; }
};

bool is_inaccurate(const Comparison& comparison, const GroundTruth& exact) {
    const DistanceResult& ours = comparison.ours;
    const ErrorLimits limits = error_limits_of(comparison.query);
    if (exceeds(ours.lower, ours.distance) || exceeds(ours.distance, ours.upper)) return true;
    if (!exact.is_exact()) return exceeds(ours.upper - ours.lower, limits.bounds);
    return exceeds(exact.error_of(ours.distance), limits.distance) ||
           (ours.status == DistanceStatus::touching && exceeds(std::abs(exact.value()), limits.bounds));
}

bool is_certified(const Comparison& comparison) {
    return check_certificate(comparison.query, comparison.ours) == CertificateVerdict::accepted;
}

void judge_ours(ParityRow& row, const Comparison& comparison, const GroundTruth* exact, double bound,
                Findings& findings) {
    const bool is_wrong = exact && exact->ours_is_wrong(comparison.ours);
    const bool is_imprecise = exact && is_inaccurate(comparison, *exact);
    const bool is_unproved = exact && !is_wrong && !is_certified(comparison);
    if (is_wrong || is_imprecise || is_unproved) {
        ++row.ours_wrong;
        findings.ours = true;
        findings.add_reason(is_wrong       ? "tumble's bounds or status"
                            : is_imprecise ? "tumble's accuracy"
                                           : "tumble's certificate");
    }
    if (exceeds(witness_error(comparison.query, comparison.ours), bound)) {
        ++row.ours_witness_wrong;
        findings.ours = true;
        findings.add_reason("tumble's witness points");
    }
}

void judge_box2d(ParityRow& row, const Comparison& comparison, const GroundTruth* exact, double error, double bound,
                 Findings& findings) {
    const bool by_flag = exact && contradicts(*comparison.box2d, exact->sign());
    const bool by_distance = exact && exceeds(error, bound);
    row.box2d_wrong_flag += by_flag;
    row.box2d_wrong_distance += by_distance;
    row.box2d_wrong += by_flag || by_distance;
    findings.box2d = by_flag || by_distance;
    findings.box2d_flag = by_flag;
    if (by_flag) findings.add_reason("Box2D's overlap flag");
    if (by_distance) findings.add_reason("Box2D's distance");
    if (has_comparable_witness(*comparison.box2d) &&
        exceeds(witness_error(comparison.query, *comparison.box2d), bound)) {
        ++row.box2d_witness_wrong;
        findings.add_reason("Box2D's witness points");
    }
}

bool differ(const Comparison& comparison, const GroundTruth& exact, double bound) {
    const B2Distance& box2d = *comparison.box2d;
    if (exceeds(clamped_difference(comparison), bound) || contradicts(box2d, sign_of(comparison.ours.status)))
        return true;
    if (!exact.has_unique_pair() || !has_comparable_witness(box2d)) return false;
    return exceeds(length(comparison.ours.point_a - box2d.point_a), bound) ||
           exceeds(length(comparison.ours.point_b - box2d.point_b), bound);
}

void add_ours_error(ParityRow& row, const Comparison& comparison, double error) {
    row.max_error_ours_m = std::max(row.max_error_ours_m, error);
    const double unit = error_unit(comparison.query);
    if (unit > 0.0) row.max_error_ours_units = std::max(row.max_error_ours_units, error / unit);
}

}  // namespace

GroundTruth GroundTruth::of_distance(ExactDistance exact) {
    GroundTruth truth;
    truth.exact_ = std::move(exact);
    return truth;
}

GroundTruth GroundTruth::of_certificate(const PairQuery& query, const DistanceResult& ours) {
    GroundTruth truth;
    truth.proved_ =
        ours.status != DistanceStatus::invalid && check_certificate(query, ours) == CertificateVerdict::accepted;
    truth.lower_ = ours.lower;
    truth.upper_ = ours.upper;
    return truth;
}

bool GroundTruth::ours_is_wrong(const DistanceResult& ours) const {
    if (!exact_) return !proved_;
    return ours.status == DistanceStatus::invalid || !(std::isfinite(ours.lower) && std::isfinite(ours.upper)) ||
           exact_->compare(ours.lower) < 0 || exact_->compare(ours.upper) > 0 || contradicts(ours.status, sign());
}

int GroundTruth::sign() const {
    if (exact_) return exact_->sign();
    return lower_ > 0.0 ? 1 : upper_ < 0.0 ? -1 : 0;
}

double GroundTruth::value() const { return exact_ ? exact_->value() : 0.5 * (lower_ + upper_); }

double GroundTruth::error_of(double signed_distance) const {
    if (!std::isfinite(signed_distance)) return INFINITY;
    if (exact_) return std::abs(exact_->minus(signed_distance));
    return std::max({0.0, lower_ - signed_distance, signed_distance - upper_});
}

double GroundTruth::error_of_clamped(double distance) const {
    if (!std::isfinite(distance)) return INFINITY;
    return sign() > 0 ? error_of(distance) : std::abs(distance);
}

bool needs_exact_check(const Comparison& comparison) {
    const double bound = tolerance(comparison.query);
    if (comparison.ours.status == DistanceStatus::invalid || !(comparison.ours.lower <= comparison.ours.upper))
        return true;
    return comparison.box2d && (exceeds(clamped_difference(comparison), bound) ||
                                contradicts(*comparison.box2d, sign_of(comparison.ours.status)));
}

void add_comparison(ParityRow& row, const Comparison& comparison, const GroundTruth* exact, CaseId id) {
    const double largest = largest_coordinate(comparison.query);
    const double unit = kFloatEpsilon * (largest > 0.0 ? largest : 1.0);  // if all coordinates are 0, so is every error
    const double bound = kParityTolerance * unit;
    Findings findings;
    ++row.comparisons;
    row.checked_exactly += exact != nullptr;
    row.iterations_ours += comparison.ours.iterations;
    row.max_iterations_ours = std::max(row.max_iterations_ours, int{comparison.ours.iterations});
    judge_ours(row, comparison, exact, bound, findings);
    const double error_ours = exact ? exact->error_of(comparison.ours.distance) : 0.0;
    if (exact) {
        add_ours_error(row, comparison, error_ours);
        row.histogram_ours.add(kFloatEpsilon * (error_ours / unit));
    }
    double error_box2d = 0.0;
    if (comparison.box2d) {
        error_box2d = exact ? exact->error_of_clamped(comparison.box2d->distance) : clamped_difference(comparison);
        row.iterations_box2d += static_cast<std::uint64_t>(comparison.box2d->iterations);
        row.max_iterations_box2d = std::max(row.max_iterations_box2d, comparison.box2d->iterations);
        row.max_error_box2d_m = std::max(row.max_error_box2d_m, error_box2d);
        row.max_error_box2d_eps = std::max(row.max_error_box2d_eps, error_box2d / unit);
        if (exact) row.histogram_box2d.add(kFloatEpsilon * (error_box2d / unit));
        judge_box2d(row, comparison, exact, error_box2d, bound, findings);
        findings.ill_conditioned = exact && !findings.ours && !findings.box2d && differ(comparison, *exact, bound);
        row.ill_conditioned += findings.ill_conditioned;
    } else {
        ++row.box2d_refused;
    }
    const double severity = std::max(error_box2d, findings.box2d_flag ? std::abs(exact->value()) : 0.0) / unit;
    if (findings.ours || (exact && comparison.box2d && row.is_among_worst(findings.box2d_flag, severity)))
        row.keep({row.name, id.seed, id.index, comparison.query, comparison.ours, comparison.box2d,
                  exact ? exact->value() : comparison.ours.distance, error_ours, error_box2d, error_box2d / unit,
                  findings.box2d_flag, severity, findings.verdict(), findings.reason});
}

void add_invalid_comparison(ParityRow& row, const PairQuery& query, const DistanceResult& ours, CaseId id) {
    ++row.comparisons;
    ++row.checked_exactly;
    ++row.box2d_refused;
    const auto is_nan = [](double value) { return std::isnan(value); };
    if (ours.status == DistanceStatus::invalid && is_nan(ours.distance) && is_nan(ours.lower) && is_nan(ours.upper))
        return;
    ++row.ours_wrong;
    row.keep({row.name, id.seed, id.index, query, ours, std::nullopt, NAN, 0.0, 0.0, 0.0, false, 0.0,
              ParityVerdict::ours_wrong, "tumble's answer to invalid input"});
}

}  // namespace tumble::reference
