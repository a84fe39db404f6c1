// All faces in lanes against one face after the other.
#include "narrow/distance/small_features.hpp"

#include <doctest/doctest.h>

#include "support/random_pairs.hpp"

using namespace tumble;
using namespace tumble_test;

namespace {

struct Expected {
    FoundFace found;
    bool is_of_b = false;
};

Expected deepest_one_by_one(const CorePair& pair) {
    Expected best;
    const auto consider = [&](const FoundFace& found, bool is_of_b) {
        if (found.exists && (!best.found.exists || found.face.separation > best.found.face.separation))
            best = {found, is_of_b};
    };
    for (int edge = 0; edge < pair.a.count && pair.a.count > 1; ++edge) consider(face_of_a(pair, edge), false);
    for (int edge = 0; edge < pair.b.count && pair.b.count > 1; ++edge) consider(face_of_b(pair, edge), true);
    return best;
}

// True if it is a face of B.
template <int N>
bool check_against_one_by_one(const CorePair& pair) {
    const TurnedPair<N> turned = {turn<N>(pair.a), turn<N>(pair.b)};
    const LeadingFaces<N> leading(pair, turned);
    const Expected expected = deepest_one_by_one(pair);
    REQUIRE((leading.bits != 0) == expected.found.exists);
    if (!expected.found.exists) return false;
    const OwnedFace face = leading.first();
    // A single face turns the direction into the other core's frame, lanes turn the vertices: both round.
    CHECK(std::abs(face.numbers.separation - expected.found.face.separation) <= error_bound(pair));
    if (face.is_b != static_cast<unsigned>(expected.is_of_b)) return expected.is_of_b;
    const DVec2 direction = expected.is_of_b ? DVec2{-face.numbers.outward_x, -face.numbers.outward_y}
                                             : DVec2{face.numbers.outward_x, face.numbers.outward_y};
    if (direction == expected.found.face.direction) {
        CHECK(pair_of_owner(face.is_b, face.from, face.nearest) == expected.found.face.pairs[0]);
        CHECK(pair_of_owner(face.is_b, face.to, face.nearest) == expected.found.face.pairs[1]);
    }
    return expected.is_of_b;
}

// The same face, measured alone: bit for bit.
template <int N>
void check_alone(const CorePair& pair) {
    const TurnedPair<N> turned = {turn<N>(pair.a), turn<N>(pair.b)};
    const LeadingFaces<N> leading(pair, turned);
    if (leading.bits == 0) return;
    const OwnedFace all = leading.first();
    const OwnedFace one = find_face<N>(pair, all.is_b, all.from);
    CHECK(all.to == one.to);
    CHECK(all.nearest == one.nearest);
    CHECK(all.numbers.separation == one.numbers.separation);
    CHECK(all.numbers.length == one.numbers.length);
    CHECK(all.numbers.outward_x == one.numbers.outward_x);
    CHECK(all.numbers.outward_y == one.numbers.outward_y);
    CHECK(all.numbers.second_x == one.numbers.second_x);
    CHECK(all.numbers.other_y == one.numbers.other_y);
}

}  // namespace

TEST_CASE("the leading face found in lanes is the deepest of all, for cores of one to eight vertices") {
    PairSource source(91);
    int of_b = 0, pairs = 0;
    for (int sample = 0; sample < 20000; ++sample) {
        const Pair pair = sample % 2 ? source.near_pair() : source.pair();
        const int largest = std::max(pair.a.vertex_count(), pair.b.vertex_count());
        if (largest > 8) continue;
        const CorePair cores = make_core_pair(pair.a, pair.pose_a, pair.b, pair.pose_b);
        of_b += check_against_one_by_one<8>(cores);
        check_alone<8>(cores);
        if (largest <= 4) {
            check_against_one_by_one<4>(cores);
            check_alone<4>(cores);
        }
        ++pairs;
    }
    CHECK(pairs > 10000);
    CHECK(of_b > 0.3 * pairs);
    CHECK(of_b < 0.7 * pairs);
}

TEST_CASE("points have no face; faces of both cores that are as deep all lead") {
    const Shape point = make_circle(0), box = make_box({1, 1});
    const Pose origin{}, right{{3, 0}, {}}, turned_right{{3, 0}, make_rotation(0.3)};
    const auto leading_bits = [&](const Shape& shape, const Pose& pose) {
        const CorePair pair = make_core_pair(shape, origin, shape, pose);
        const TurnedPair<4> turned = {turn<4>(pair.a), turn<4>(pair.b)};
        return LeadingFaces<4>(pair, turned).bits;
    };
    CHECK(leading_bits(point, right) == 0);
    CHECK(std::popcount(leading_bits(box, right)) == 2);
    CHECK(std::popcount(leading_bits(box, turned_right)) == 1);
}
