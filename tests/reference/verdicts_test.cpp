// The verdicts of the exact oracle and of the certificate checker are those of exact arithmetic alone, in every family:
// for answers, for forgeries, and for bounds that are wrong by one unit in the last place. Of TUMBLE_PAIRS pairs per
// family a twentieth is judged both ways.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reference/exact/certificate.hpp"
#include "reference/exact/exact_distance.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/parallel_blocks.hpp"
#include "reference/query/random.hpp"
#include "support/distance_results.hpp"
#include "tumble/distance.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble_test;

namespace {

constexpr std::uint64_t kSeed = 20261125;
constexpr std::uint64_t kBlock = 25;

struct Tally {
    std::uint64_t verdicts = 0, accepted = 0, different = 0;
    std::uint64_t planted = 0, missed = 0;  // wrong answers, and those that were not caught
    std::string example;

    void note(std::uint64_t& count, const char* what, const PairQuery& query) {
        if (count++ == 0 && example.empty()) example = std::string(what) + ": " + to_hex(query);
    }
    void merge(const Tally& later) {
        verdicts += later.verdicts;
        accepted += later.accepted;
        different += later.different;
        planted += later.planted;
        missed += later.missed;
        if (example.empty()) example = later.example;
    }
};

bool is_accepted(const PairQuery& query, const DistanceResult& answer, Arithmetic arithmetic) {
    return check_certificate(query, answer, arithmetic) == CertificateVerdict::accepted;
}

// The answer with other bounds, and the status that follows from them.
DistanceResult with_bounds(DistanceResult answer, double lower, double upper) {
    answer.lower = lower;
    answer.upper = upper;
    answer.status = lower > 0.0   ? DistanceStatus::separated
                    : upper < 0.0 ? DistanceStatus::overlapping
                                  : DistanceStatus::touching;
    return answer;
}

DistanceResult with_pair_of(DistanceResult answer, std::size_t which, VertexPair pair) {
    answer.certificate.pairs[which] = pair;
    return answer;
}

// Wrong or unlikely claims: narrow bounds, the witness of the other shape, other vertices, turned and negated
// directions, the distance with the wrong sign.
std::vector<DistanceResult> forgeries_of(const PairQuery& query, const DistanceResult& answer, Random& random) {
    const double width = answer.upper - answer.lower, narrow = random.uniform(0.0, 0.5) * width;
    const VertexPair first = answer.certificate.pairs[0];
    const VertexPair other = random_vertices(random, query);
    std::vector<DistanceResult> forgeries{
        with_bounds(answer, answer.lower + narrow, answer.upper - narrow),
        with_bounds(answer, -answer.upper, -answer.lower),
        with_pair_of(answer, 0, {first.b, first.a}),
        with_pair_of(answer, 0, {other.a, first.b}),
        with_pair_of(answer, answer.certificate.pair_count - 1u, other),
        answer,
        answer,
    };
    DVec2 &turned = forgeries[5].certificate.direction, &negated = forgeries[6].certificate.direction;
    turned += random.signed_magnitude(-60, 1) * perp(turned);
    negated = -negated;
    return forgeries;
}

void compare_certificates(Tally& tally, const PairQuery& query, const DistanceResult& answer) {
    const CertificateVerdict verdict = check_certificate(query, answer);
    ++tally.verdicts;
    tally.accepted += verdict == CertificateVerdict::accepted;
    if (verdict != check_certificate(query, answer, Arithmetic::exact_only))
        tally.note(tally.different, "certificate", query);
}

void compare_distances(Tally& tally, const PairQuery& query, const DistanceResult& answer, Random& random) {
    const ExactDistance distance(query), exactly(query, Arithmetic::exact_only);
    const double nearby = answer.distance + random.signed_magnitude(-70, -40) * (std::abs(answer.distance) + 1.0);
    for (const double x : {answer.lower, answer.upper, answer.distance, 0.0, nearby, exactly.value()}) {
        ++tally.verdicts;
        if (distance.compare(x) != exactly.compare(x) || distance.compare(x, nearby) != exactly.compare(x, nearby))
            tally.note(tally.different, "comparison", query);
    }
    if (!have_same_bits(distance.minus(answer.distance), exactly.minus(answer.distance)) ||
        distance.has_unique_pair() != exactly.has_unique_pair())
        tally.note(tally.different, "value", query);
}

// The doubles next to the exact distance, below and above it.
std::pair<double, double> neighbours(const ExactDistance& exact) {
    const double value = exact.value();
    return {exact.compare(value) > 0 ? value : std::nextafter(value, -INFINITY),
            exact.compare(value) < 0 ? value : std::nextafter(value, INFINITY)};
}

// The double nearest to `rejected` among those from `accepted` on that exact arithmetic accepts.
template <class Accepts>
double last_accepted(double accepted, double rejected, Accepts accepts) {
    for (;;) {
        const double middle = accepted + (rejected - accepted) / 2;
        if (middle == accepted || middle == rejected) return accepted;
        (accepts(middle) ? accepted : rejected) = middle;
    }
}

void expect_caught(Tally& tally, bool is_caught, const char* what, const PairQuery& query) {
    ++tally.planted;
    if (!is_caught) tally.note(tally.missed, what, query);
}

// Bounds that miss the exact distance by less than one unit in the last place, and the first ones that the certificate
// does not prove.
void plant_wrong_bounds(Tally& tally, const PairQuery& query, const DistanceResult& answer) {
    const ExactDistance exact(query);
    const auto [below, above] = neighbours(exact);
    const DistanceResult high = with_bounds(answer, above, std::max(above, answer.upper));
    const DistanceResult low = with_bounds(answer, std::min(below, answer.lower), below);
    expect_caught(tally, fit_of(query, high, ExactDistance(query)) == BoundsFit::wrong, "lower bound above", query);
    expect_caught(tally, fit_of(query, low, ExactDistance(query)) == BoundsFit::wrong, "upper bound below", query);
    expect_caught(tally, !is_accepted(query, high, Arithmetic::intervals_first), "certified above", query);
    expect_caught(tally, !is_accepted(query, low, Arithmetic::intervals_first), "certified below", query);

    const auto with_lower = [&](double x) { return with_bounds(answer, x, std::max(x, answer.upper)); };
    const double lower = last_accepted(
        answer.lower, above, [&](double x) { return is_accepted(query, with_lower(x), Arithmetic::exact_only); });
    expect_caught(tally,
                  is_accepted(query, with_lower(lower), Arithmetic::intervals_first) &&
                      !is_accepted(query, with_lower(std::nextafter(lower, INFINITY)), Arithmetic::intervals_first),
                  "largest proved lower bound", query);
}

Tally judge_pair(const PairFamily& family, std::uint64_t index, bool is_planted) {
    Tally tally;
    const PairQuery query = family.generate(kSeed, index);
    Random random(~kSeed, index);
    const DistanceResult answer = distance(query.a, query.pose_a, query.b, query.pose_b);
    compare_certificates(tally, query, answer);
    for (const DistanceResult& forgery : forgeries_of(query, answer, random))
        compare_certificates(tally, query, forgery);
    if (family.kind == FamilyKind::large) return tally;
    compare_distances(tally, query, answer, random);
    if (is_planted) plant_wrong_bounds(tally, query, answer);
    return tally;
}

Tally judge_family(const PairFamily& family) {
    const std::uint64_t pairs = std::max<std::uint64_t>(pairs_of(family, 10000) / 20, 1);
    Tally tally;
    run_blocks<Tally>((pairs + kBlock - 1) / kBlock, 0,
                      [&](std::size_t block) {
                          Tally part;
                          for (std::uint64_t i = block * kBlock; i < std::min((block + 1) * kBlock, pairs); ++i)
                              part.merge(judge_pair(family, i, i % kBlock == 0));
                          return part;
                      },
                      [&](std::size_t, const Tally& part) { tally.merge(part); });
    return tally;
}

}  // namespace

TEST_CASE(
    "the verdicts are those of exact arithmetic alone, and bounds wrong by one unit in the last place are caught") {
    Tally total;
    for (const PairFamily& family : pair_families()) {
        if (family.kind == FamilyKind::invalid || !is_family_selected(family.name)) continue;
        const Tally tally = judge_family(family);
        INFO(family.name << ": " << tally.example);
        CHECK(tally.different == 0);
        CHECK(tally.missed == 0);
        total.merge(tally);
    }
    if (is_every_family_selected()) {
        CHECK(total.planted > 1000);
        CHECK(10 * total.accepted > total.verdicts);
        CHECK(10 * total.accepted < 9 * total.verdicts);
    }
    MESSAGE(total.verdicts << " verdicts, " << total.accepted << " certificates accepted, " << total.planted
                           << " wrong bounds");
}
