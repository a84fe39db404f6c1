// The narrow phase does not allocate: every `new` of this program is counted.
#include <doctest/doctest.h>

#include <cstdlib>
#include <new>

#include "support/random_pairs.hpp"
#include "tumble/cast.hpp"
#include "tumble/manifold.hpp"

namespace {

long allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

TEST_CASE("distance, by any method, and collide do not allocate") {
    using namespace tumble_test;
    PairSource source(81);
    double sum = 0.0;
    for (int sample = 0; sample < 2000; ++sample) {
        const Pair pair = sample % 2 ? source.near_pair() : source.pair();
        tumble::SimplexCache cache;
        const long before = allocations;
        sum += measure(pair, &cache).distance;
        for (const auto by :
             {tumble::SubAlgorithm::voronoi, tumble::SubAlgorithm::johnson, tumble::SubAlgorithm::signed_volumes})
            sum += tumble::gjk_distance(pair.a, pair.pose_a, pair.b, pair.pose_b, by, &cache).distance;
        sum += tumble::collide(pair.a, pair.pose_a, pair.b, pair.pose_b, 0.02, cache).point_count;
        CHECK(allocations == before);
    }
    std::vector<Pair> pairs;
    for (int sample = 0; sample < 100; ++sample) pairs.push_back(source.pair());
    std::vector<tumble::PosedPair> posed;
    for (const Pair& pair : pairs) posed.push_back({&pair.a, pair.pose_a, &pair.b, pair.pose_b});
    std::vector<tumble::DistanceResult> results(posed.size());
    const long before = allocations;
    tumble::distance_batch(posed, results);
    CHECK(allocations == before);
    CHECK(allocations > 0);  // the shapes allocate: the counter works
    CHECK(sum != 0.0);
}

TEST_CASE("rays, casts and times of impact do not allocate") {
    using namespace tumble;
    tumble_test::PairSource source(82);
    int hits = 0;
    for (int sample = 0; sample < 2000; ++sample) {
        const tumble_test::Pair pair = source.pair();
        const DVec2 offset = pair.pose_b.position - pair.pose_a.position, displacement = -1.5 * offset;
        const Sweep still{{}, pair.pose_a.position, pair.pose_a.position, 0.0, 0.5};
        const Sweep moving{{}, pair.pose_b.position, pair.pose_b.position + displacement, 1.0, sample % 3 - 1.0};
        const long before = allocations;
        hits += cast_ray(pair.a, pair.pose_a, pair.pose_b.position, displacement).status == CastStatus::hit;
        hits += cast_shape(pair.a, pair.pose_a, pair.b, pair.pose_b, displacement, 0.01).status == CastStatus::hit;
        hits += swept_overlap(pair.a, pair.pose_a, pair.b, pair.pose_b, displacement) == DistanceStatus::overlapping;
        hits += time_of_impact(pair.a, still, pair.b, moving).status == CastStatus::hit;
        CHECK(allocations == before);
    }
    CHECK(hits > 2000);  // of 8000: many searches end with a hit
}
