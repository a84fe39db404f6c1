// Rays, casts and times of impact over their families, against closed forms and proved intervals in long double. The
// judge itself is tested with wrong answers. TUMBLE_PAIRS=1000000 runs a million pairs per family.
#include "reference/families/cast_families.hpp"
#include "reference/box2d/b2_cast.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "reference/parity/cast_judge.hpp"
#include "reference/parity/parallel_blocks.hpp"
#include "support/moving_pairs.hpp"

using namespace tumble;
using namespace tumble::reference;

namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kBlock = 250;

// Counts of the verdicts, and the first wrong one. Merged in the order of the pairs.
struct Tally {
    std::map<CastVerdict, std::uint64_t> verdicts;
    std::string first_wrong;
};

Tally check_block(const CastFamily& family, std::uint64_t begin, std::uint64_t end) {
    Tally tally;
    for (std::uint64_t index = begin; index < end; ++index) {
        const CastQuery query = family.generate(kSeed, index);
        const CastVerdict verdict = judge(MotionOracle(query), query_tumble(query));
        ++tally.verdicts[verdict];
        if (is_wrong(verdict) && tally.first_wrong.empty())
            tally.first_wrong = ", pair " + std::to_string(index) + ": " + to_string(verdict);
    }
    return tally;
}

Tally check_family(const CastFamily& family, std::uint64_t count) {
    Tally total;
    run_blocks<Tally>(
        (count + kBlock - 1) / kBlock, 0,
        [&](std::size_t block) { return check_block(family, block * kBlock, std::min((block + 1) * kBlock, count)); },
        [&](std::size_t, const Tally& part) {
            for (const auto& [verdict, number] : part.verdicts) total.verdicts[verdict] += number;
            if (total.first_wrong.empty()) total.first_wrong = part.first_wrong;
        });
    return total;
}

CastQuery boxes_approaching(CastKind kind) {
    CastQuery query;
    query.kind = kind;
    query.a = query.b = make_box({1, 1});
    query.pose_b.position = {3, 0.25};
    query.translation = {-4, 0};
    query.sweep_a = {{}, {}, {}, 0.0, 0.0};
    query.sweep_b = {{}, {3, 0.25}, {-1, 0.25}, 0.0, kind == CastKind::impact ? 0.5 : 0.0};
    return query;
}

}  // namespace

TEST_CASE("no family of moving pairs has a missed hit, a false hit or a wrong bracket") {
    for (const CastFamily& family : cast_families()) {
        const std::uint64_t count = tumble_test::pair_count() >= 1000000 ? 1000000 : tumble_test::pair_count() / 4;
        const Tally tally = check_family(family, count);
        INFO(family.name << tally.first_wrong);
        CHECK(tally.first_wrong.empty());
        const auto share = [&](CastVerdict verdict) {
            const auto found = tally.verdicts.find(verdict);
            return found == tally.verdicts.end() ? 0.0
                                                 : static_cast<double>(found->second) / static_cast<double>(count);
        };
        CHECK(share(CastVerdict::hit) > 0.3);
        CHECK(share(CastVerdict::miss) > 0.3);
        CHECK(share(CastVerdict::overlap) > 0.01);
        CHECK(share(CastVerdict::graze) < 0.001);
        std::string line(family.name);
        for (const auto& [verdict, number] : tally.verdicts)
            line += ", " + std::string(to_string(verdict)) + " " + std::to_string(number);
        MESSAGE(line);
    }
}

TEST_CASE("the judge of moving pairs detects late, early, missed and false hits and wrong brackets") {
    for (const CastKind kind : {CastKind::shape, CastKind::impact}) {
        const CastQuery query = boxes_approaching(kind);
        const MotionOracle oracle(query);
        const CastResult right = query_tumble(query);
        REQUIRE(right.status == CastStatus::hit);
        CHECK(judge(oracle, right) == CastVerdict::hit);
        const auto moved = [&](double by) {
            CastResult result = right;
            result.lower += by;
            result.fraction += by;
            result.upper += by;
            return judge(oracle, result);
        };
        CHECK(moved(1e-12) == CastVerdict::missed);
        CHECK(moved(-1e-12) == CastVerdict::false_hit);
        CastResult blind = right;
        blind.status = CastStatus::miss;
        CHECK(judge(oracle, blind) == CastVerdict::missed);
        CastResult narrow = right;
        narrow.upper = narrow.fraction = narrow.lower = right.fraction - (right.upper - right.fraction);
        CHECK(is_wrong(judge(oracle, narrow)));
        CastResult inside = right;
        inside.status = CastStatus::overlapping;
        CHECK(judge(oracle, inside) == CastVerdict::false_hit);
    }
    CastQuery beside = boxes_approaching(CastKind::shape);
    beside.pose_b.position.y = 1.0 + 1e-9;
    CHECK(judge(MotionOracle(beside), query_tumble(beside)) == CastVerdict::miss);
    CastResult made_up = query_tumble(boxes_approaching(CastKind::shape));
    CHECK(judge(MotionOracle(beside), made_up) == CastVerdict::false_hit);
}

TEST_CASE("Box2D finds the same impact of two boxes, within its slop") {
    for (const CastKind kind : {CastKind::ray, CastKind::shape, CastKind::impact}) {
        CastQuery query = boxes_approaching(kind);
        query.target = b2_target(kind);
        if (kind == CastKind::ray) query.b = make_circle(0);
        const std::optional<B2Cast> box2d = query_box2d(query);
        REQUIRE(box2d);
        CHECK(box2d->hits);
        CHECK(judge(MotionOracle(query), *box2d, box2d->tolerance + 1e-6) == CastVerdict::hit);
        query.target += 0.1;  // not the target of Box2D
        if (kind != CastKind::ray) CHECK(!query_box2d(query));
    }
}
