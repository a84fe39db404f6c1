// Every hard family against the exact oracle and the certificate checker: bounds, status, certificates, and perturbed
// certificates. The environment variable TUMBLE_PAIRS sets the pairs per family (10 000); families of large polygons
// take a fiftieth. TUMBLE_FAMILY selects a single family.
#include "reference/families/pair_families.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "narrow/cores/error_bound.hpp"
#include "reference/exact/certificate.hpp"
#include "reference/exact/exact_distance.hpp"
#include "reference/parity/parallel_blocks.hpp"
#include "reference/query/random.hpp"
#include "support/distance_results.hpp"
#include "support/near.hpp"
#include "tumble/distance.hpp"

using namespace tumble;
using namespace tumble::reference;
using namespace tumble::test;
using namespace tumble_test;

namespace {

constexpr std::uint64_t kSeed = 20261121;
constexpr std::uint64_t kBlock = 250;
constexpr std::uint64_t kUsualPairs = 10000;

// Counts of the failures in a family, with the first example. Merged in the order of the pairs.
struct Tally {
    std::uint64_t bounds_wrong = 0, bounds_loose = 0, status_wrong = 0, rejected = 0, accepted_perturbed = 0,
                  warm_wrong = 0;
    std::uint64_t perturbed = 0, separated = 0, overlapping = 0, touching = 0, reached_cap = 0;
    double largest_error = 0.0;  // of the bare cores, in units of u (RA + RB + |p|)
    int most_iterations = 0;
    std::string example;

    void note(std::uint64_t& count, const char* what, const PairQuery& query, std::uint64_t index) {
        if (count++ == 0 && example.empty())
            example = std::string(what) + " at " + std::to_string(index) + ": " + to_hex(query);
    }
    void merge(const Tally& later) {
        bounds_wrong += later.bounds_wrong;
        bounds_loose += later.bounds_loose;
        status_wrong += later.status_wrong;
        rejected += later.rejected;
        accepted_perturbed += later.accepted_perturbed;
        warm_wrong += later.warm_wrong;
        perturbed += later.perturbed;
        separated += later.separated;
        overlapping += later.overlapping;
        touching += later.touching;
        reached_cap += later.reached_cap;
        largest_error = std::max(largest_error, later.largest_error);
        most_iterations = std::max(most_iterations, later.most_iterations);
        if (example.empty()) example = later.example;
    }
};

struct LongPoint {
    long double x = 0.0L, y = 0.0L;
};

long double dot(LongPoint p, LongPoint q) { return p.x * q.x + p.y * q.y; }
long double length(LongPoint p) { return std::sqrt(dot(p, p)); }

LongPoint turned(const Shape& shape, Rotation q, int i) {
    const long double c = q.c, s = q.s, x = shape.vertex(i).x, y = shape.vertex(i).y;
    return {c * x - s * y, s * x + c * y};
}

LongPoint minkowski_vertex(const PairQuery& query, VertexPair pair) {
    const LongPoint a = turned(query.a, query.pose_a.rotation, pair.a),
                    b = turned(query.b, query.pose_b.rotation, pair.b);
    const DVec2 pa = query.pose_a.position, pb = query.pose_b.position;
    return {a.x - b.x - (static_cast<long double>(pb.x) - pa.x), a.y - b.y - (static_cast<long double>(pb.y) - pa.y)};
}

// The core distance that the claimed pairs attain: for separated cores the distance of their simplex from the origin,
// for overlapping cores the separation of their face, negative.
long double claimed_distance(const PairQuery& query, const Certificate& certificate) {
    const LongPoint p = minkowski_vertex(query, certificate.pairs[0]);
    const LongPoint q = minkowski_vertex(query, certificate.pairs[certificate.pair_count - 1u]);
    const LongPoint edge{q.x - p.x, q.y - p.y};
    const long double edge_sq = dot(edge, edge);
    if (certificate.cores_overlap) {
        if (edge_sq == 0.0L) return -length(p);
        const long double side =
            certificate.direction.x * edge.y - certificate.direction.y * edge.x < 0.0L ? -1.0L : 1.0L;
        return side * (p.y * edge.x - p.x * edge.y) / std::sqrt(edge_sq);
    }
    const long double t = edge_sq > 0.0L ? std::clamp(-dot(p, edge) / edge_sq, 0.0L, 1.0L) : 0.0L;
    return length({p.x + t * edge.x, p.y + t * edge.y});
}

// -h / |direction| of the core difference.
long double claimed_lower(const PairQuery& query, DVec2 direction) {
    const long double scale = std::max(std::abs(direction.x), std::abs(direction.y));
    const LongPoint d{direction.x / scale, direction.y / scale};
    long double highest_a = -INFINITY, lowest_b = INFINITY;
    for (int i = 0; i < query.a.vertex_count(); ++i)
        highest_a = std::max(highest_a, dot(d, turned(query.a, query.pose_a.rotation, i)));
    for (int i = 0; i < query.b.vertex_count(); ++i)
        lowest_b = std::min(lowest_b, dot(d, turned(query.b, query.pose_b.rotation, i)));
    const DVec2 pa = query.pose_a.position, pb = query.pose_b.position;
    const LongPoint offset{static_cast<long double>(pb.x) - pa.x, static_cast<long double>(pb.y) - pa.y};
    return -(highest_a - lowest_b - dot(d, offset)) / length(d);
}

// Replaces an index, and rotates the direction. The checker must reject a forgery that proves a value more than 2 E
// away: a claim is within E of the value computed from it, and the bound is E from that. A thousandth is added for the
// long double arithmetic of the test.
void check_perturbed(Tally& tally, const PairQuery& query, const DistanceResult& answer, Random& random,
                     std::uint64_t index) {
    const long double bound = 2.002L * core_error_bound(query);
    DistanceResult forged = answer;
    VertexPair& pair =
        forged.certificate.pairs[static_cast<std::size_t>(random.integer(0, answer.certificate.pair_count - 1))];
    if (random.chance(0.5)) {
        pair.a = static_cast<std::uint16_t>(random.integer(0, query.a.vertex_count() - 1));
    } else {
        pair.b = static_cast<std::uint16_t>(random.integer(0, query.b.vertex_count() - 1));
    }
    if (std::abs(claimed_distance(query, forged.certificate) - claimed_distance(query, answer.certificate)) > bound) {
        ++tally.perturbed;
        if (check_certificate(query, forged) == CertificateVerdict::accepted)
            tally.note(tally.accepted_perturbed, "perturbed pairs accepted", query, index);
    }
    forged = answer;
    const DVec2 d = answer.certificate.direction;
    forged.certificate.direction = d + random.signed_magnitude(-50, 1) * perp(d);
    if (claimed_lower(query, d) - claimed_lower(query, forged.certificate.direction) > bound) {
        ++tally.perturbed;
        if (check_certificate(query, forged) == CertificateVerdict::accepted)
            tally.note(tally.accepted_perturbed, "perturbed direction accepted", query, index);
    }
}

void count_status(Tally& tally, const DistanceResult& answer) {
    tally.separated += answer.status == DistanceStatus::separated;
    tally.overlapping += answer.status == DistanceStatus::overlapping;
    tally.touching += answer.status == DistanceStatus::touching;
    tally.reached_cap += answer.reached_cap;
    tally.most_iterations = std::max(tally.most_iterations, int{answer.iterations});
}

SimplexCache random_cache(Random& random, const PairQuery& query) {
    const bool in_range = random.chance(0.5);
    SimplexCache cache;
    cache.count = static_cast<std::uint8_t>(in_range ? random.integer(0, 3) : random.integer(0, 255));
    for (VertexPair& pair : cache.pairs) {
        pair.a = static_cast<std::uint16_t>(random.integer(0, in_range ? query.a.vertex_count() - 1 : 65535));
        pair.b = static_cast<std::uint16_t>(random.integer(0, in_range ? query.b.vertex_count() - 1 : 65535));
    }
    return cache;
}

constexpr std::uint64_t kPairsPerLooseOne = 100000;  // with bounds looser than usual; seen once in 40 million pairs

void check_exact(Tally& tally, const PairQuery& query, const DistanceResult& answer, const ExactDistance& exact,
                 std::uint64_t index) {
    switch (fit_of(query, answer, exact)) {
        case BoundsFit::near: break;
        case BoundsFit::loose:
            tally.note(tally.bounds_loose, "bounds far from the exact distance", query, index);
            break;
        case BoundsFit::wrong:
            tally.note(tally.bounds_wrong, "not a tight bracket of the exact distance", query, index);
            break;
    }
    if (!is_status_right(answer.status, exact)) tally.note(tally.status_wrong, "status", query, index);
}

// Computes the error exactly if it is larger than all before, and than an eighth of a unit.
void note_error(Tally& tally, const PairQuery& bare, const ExactDistance& exact, double distance) {
    const double unit = kUnitRoundoff * error_scale(bare), largest = std::max(tally.largest_error, 0.125) * unit;
    if (exact.compare(distance, largest) <= 0 && exact.compare(distance, -largest) >= 0) return;
    const double error = std::abs(exact.minus(distance));
    if (error > 0.0) tally.largest_error = std::max(tally.largest_error, error / unit);
}

void check_pair(Tally& tally, const PairFamily& family, std::uint64_t index) {
    const PairQuery query = family.generate(kSeed, index);
    const DistanceResult answer = distance(query.a, query.pose_a, query.b, query.pose_b);
    count_status(tally, answer);
    if (family.kind == FamilyKind::invalid) {
        if (answer.status != DistanceStatus::invalid) tally.note(tally.status_wrong, "status", query, index);
        return;
    }
    if (answer.status == DistanceStatus::invalid) return tally.note(tally.status_wrong, "refused", query, index);
    if (check_certificate(query, answer) != CertificateVerdict::accepted)
        tally.note(tally.rejected, to_string(check_certificate(query, answer)), query, index);

    Random random(~kSeed, index);
    SimplexCache cache = random_cache(random, query);
    const DistanceResult warm = distance(query.a, query.pose_a, query.b, query.pose_b, &cache);
    if (!(warm.status == answer.status && warm.lower <= answer.upper && answer.lower <= warm.upper))
        tally.note(tally.warm_wrong, "warm answer", query, index);

    const PairQuery bare = query.without_radii();
    const DistanceResult bare_answer = distance(bare.a, bare.pose_a, bare.b, bare.pose_b);
    check_perturbed(tally, bare, bare_answer, random, index);
    if (family.kind == FamilyKind::large) return;
    const ExactDistance exact(query);
    check_exact(tally, query, answer, exact, index);
    note_error(tally, bare, exact.with_radii(0.0, 0.0), bare_answer.distance);
}

Tally check_family(const PairFamily& family) {
    Tally tally;
    const std::uint64_t pairs = pairs_of(family, kUsualPairs);
    run_blocks<Tally>((pairs + kBlock - 1) / kBlock, 0,
                      [&](std::size_t block) {
                          Tally part;
                          for (std::uint64_t i = block * kBlock; i < std::min((block + 1) * kBlock, pairs); ++i)
                              check_pair(part, family, i);
                          return part;
                      },
                      [&](std::size_t, const Tally& part) { tally.merge(part); });
    return tally;
}

}  // namespace

TEST_CASE(
    "every family: the exact distance is within tight bounds, the status is right, certificates are accepted and "
    "forgeries rejected") {
    double largest_error = 0.0;
    std::uint64_t pairs = 0, forgeries = 0;
    for (const PairFamily& family : pair_families()) {
        if (!is_family_selected(family.name)) continue;
        const Tally tally = check_family(family);
        INFO(family.name << ": " << tally.example);
        CHECK(tally.bounds_wrong == 0);
        CHECK(tally.bounds_loose <= pairs_of(family, kUsualPairs) / kPairsPerLooseOne);
        CHECK(tally.status_wrong == 0);
        CHECK(tally.rejected == 0);
        CHECK(tally.accepted_perturbed == 0);
        CHECK(tally.warm_wrong == 0);
        largest_error = std::max(largest_error, tally.largest_error);
        pairs += pairs_of(family, kUsualPairs);
        forgeries += tally.perturbed;
        MESSAGE(family.name << ": " << pairs_of(family, kUsualPairs) << " pairs, " << tally.separated << " separated, "
                            << tally.overlapping << " overlapping, " << tally.touching << " touching, "
                            << tally.perturbed << " forgeries, largest error " << tally.largest_error
                            << " u (RA + RB + |p|), at most " << tally.most_iterations << " iterations, "
                            << tally.reached_cap << " at the cap");
    }
    CHECK(largest_error < 16.0);
    if (is_every_family_selected()) {
        CHECK(largest_error > 0.5);  // the oracle resolves rounding errors
        CHECK(forgeries > pairs / 2);
    }
    MESSAGE("largest error of all families: " << largest_error << " u (RA + RB + |p|)");
}

TEST_CASE("families repeat from seed and index, differ by seed, and have different names") {
    std::vector<std::string_view> names;
    for (const PairFamily& family : pair_families()) {
        INFO(family.name);
        names.push_back(family.name);
        CHECK(find_pair_family(family.name) == &family);
        CHECK(to_hex(family.generate(1, 7)) == to_hex(family.generate(1, 7)));
        CHECK(to_hex(family.generate(1, 7)) != to_hex(family.generate(2, 7)));
        CHECK(to_hex(family.generate(1, 7)) != to_hex(family.generate(1, 100)));
    }
    std::ranges::sort(names);
    CHECK(std::ranges::adjacent_find(names) == names.end());
    CHECK(find_pair_family("no_such_family") == nullptr);
}

TEST_CASE("generated numbers are the same on every platform") {
    Random random(1, 2);
    CHECK(random.bits() == 8471076162667867070u);
    CHECK(random.integer(-3, 3) == 3);
    CHECK(random.magnitude(-2, 2) == 0x1.82fa2be5ad54dp+1);
    CHECK(random.direction() == DVec2{0x1.9dd819cdb79b7p-2, 0x1.d452e9c57dcd9p-1});
}

TEST_CASE("the answers to the regression cases are right and certified") {
    REQUIRE_FALSE(regression_cases().empty());
    for (const RegressionCase& regression : regression_cases()) {
        INFO(regression.name << ": " << to_hex(regression.query));
        const PairQuery& q = regression.query;
        const DistanceResult answer = distance(q.a, q.pose_a, q.b, q.pose_b);
        const ExactDistance exact(q);
        CHECK(exact.sign() == regression.expected_sign);
        CHECK(exact.compare(answer.lower) >= 0);
        CHECK(exact.compare(answer.upper) <= 0);
        CHECK(is_status_right(answer.status, exact));
        CHECK(check_certificate(q, answer) == CertificateVerdict::accepted);
        CHECK_FALSE(answer.reached_cap);
        CHECK(near(length(answer.normal), 1.0, kDouble));
    }
}

TEST_CASE("a certificate proves the upper bound also where rounding leaves open whether the cores overlap") {
    // 10 km against 1 mm, 1.01 E deep by exact arithmetic and 0.998 E by ours: no overlap is claimed, and the face is
    // farther from the origin than E.
    const auto* const family = find_pair_family("mixed_scales");
    REQUIRE(family);
    const PairQuery query = family->generate(20261121, 127616);
    const DistanceResult answer = distance(query.a, query.pose_a, query.b, query.pose_b);
    const double bound = core_error_bound(query);
    CHECK(answer.status == DistanceStatus::touching);
    CHECK(answer.distance > -bound);
    CHECK(ExactDistance(query).compare(-bound) < 0);
    CHECK(check_certificate(query, answer) == CertificateVerdict::accepted);
}

TEST_CASE("the pairs of families of touching, separated or overlapping shapes touch, are separated or overlap") {
    const auto count = [](std::string_view name, int sign) {
        const PairFamily* family = find_pair_family(name);
        REQUIRE(family != nullptr);
        int matching = 0;
        for (std::uint64_t index = 0; index < 500; ++index)
            matching += ExactDistance(family->generate(3, index)).sign() == sign;
        return matching;
    };
    for (const char* name : {"touching_vertices", "touching_vertex_edge", "touching_edges"})
        CHECK(count(name, 0) == 500);
    CHECK(count("near_gap", 1) > 450);  // the rounded rotation of an edge may make a corner overlap
    CHECK(count("near_overlap", -1) > 490);
    CHECK(count("random", -1) > 150);
    CHECK(count("random", 1) > 150);
    CHECK(count("identical", -1) > 400);
    CHECK(count("touching_circles", 0) > 100);
    CHECK(count("touching_rounded", 0) > 100);
}
