// Repeaters: poses worked out by hand, and the guarantees of a scatter.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <set>

#include "scene/format/random.hpp"
#include "scene/model/repeat.hpp"

using namespace tumble;
using scene::CopyPose;

namespace {

SceneBody repeated(SceneRepeat repeat) {
    SceneBody body;
    body.position = {10, 20};
    body.angle = 5;
    body.repeat = repeat;
    return body;
}

std::vector<CopyPose> poses_of(SceneRepeat repeat, std::uint64_t seed = 1, std::uint64_t stream = 0) {
    const SceneBody body = repeated(repeat);
    std::vector<CopyPose> poses = scene::copy_poses(body, seed, stream);
    CHECK(scene::copy_count(body) == std::ssize(poses));
    return poses;
}

}  // namespace

TEST_CASE("a body without a repeater has one pose, its own") {
    SceneBody body;
    body.position = {1, 2};
    REQUIRE(scene::copy_count(body) == 1);
    CHECK(scene::copy_poses(body, 1, 0)[0].position == DVec2(1, 2));
}

TEST_CASE("a grid is filled row by row, upwards") {
    const std::vector<CopyPose> poses = poses_of(GridRepeat{2, 3, {4, 0.5}});
    REQUIRE(poses.size() == 6);
    CHECK(poses[1].position == DVec2(14, 20));
    CHECK(poses[2].position == DVec2(10, 20.5));
    CHECK(poses[5].position == DVec2(14, 21));
    CHECK(poses[5].angle == 5);
}

TEST_CASE("a pyramid's rows shrink by one and are centred on each other") {
    // base 3: 3 + 2 + 1 copies; each row starts half a spacing to the right
    const std::vector<CopyPose> poses = poses_of(PyramidRepeat{3, {2, 1}});
    REQUIRE(poses.size() == 6);
    CHECK(poses[2].position == DVec2(14, 20));
    CHECK(poses[3].position == DVec2(11, 21));
    CHECK(poses[4].position == DVec2(13, 21));
    CHECK(poses[5].position == DVec2(12, 22));
}

TEST_CASE("a ring starts at the right and continues counter-clockwise") {
    const std::vector<CopyPose> poses = poses_of(RingRepeat{4, 3, true});
    REQUIRE(poses.size() == 4);
    const DVec2 expected[] = {{13, 20}, {10, 23}, {7, 20}, {10, 17}};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(length(poses[i].position - expected[i]) < 1e-14);
        CHECK(poses[i].angle == 5 + 90.0 * static_cast<double>(i));
    }
    CHECK(poses_of(RingRepeat{4, 3, false})[1].angle == 5);
}

TEST_CASE("a scatter stays in its box, fills it, and keeps its separation") {
    const ScatterRepeat scatter{400, {20, 10}, true, 0.4};
    const std::vector<CopyPose> poses = poses_of(scatter);
    int quadrants[4] = {};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const DVec2 offset = poses[i].position - DVec2(10, 20);
        CHECK(std::abs(offset.x) <= 10);
        CHECK(std::abs(offset.y) <= 5);
        ++quadrants[(offset.x > 0 ? 1 : 0) + (offset.y > 0 ? 2 : 0)];
        CHECK(poses[i].angle >= 5);
        CHECK(poses[i].angle < 365);
        for (std::size_t j = 0; j < i; ++j) CHECK(length(poses[i].position - poses[j].position) >= 0.4);
    }
    // Binomial with n = 400, p = 1/4: mean 100, deviation below 9 (the separation only evens it out).
    for (const int count : quadrants) CHECK(std::abs(count - 100) < 5 * 9);
}

TEST_CASE("a scatter depends on its seed and its stream alone") {
    const ScatterRepeat scatter{20, {1, 1}, false, 0};
    const auto first = poses_of(scatter, 7, 3);
    REQUIRE(first.size() == 20);
    CHECK(first[19].position == poses_of(scatter, 7, 3)[19].position);
    CHECK(first[0].position != poses_of(scatter, 8, 3)[0].position);
    CHECK(first[0].position != poses_of(scatter, 7, 4)[0].position);
}

TEST_CASE("a scatter without room reports how many copies fit") {
    CHECK_THROWS_WITH_AS(poses_of(ScatterRepeat{5, {0, 0}, false, 1}), doctest::Contains("found room for only 1 of 5"),
                         std::invalid_argument);
}

TEST_CASE("a copy without extent may be repeated at one position") {
    CHECK(poses_of(ScatterRepeat{3, {0, 0}, false, 0})[2].position == DVec2(10, 20));
}

TEST_CASE("the random numbers are those of SplitMix64") {
    // The published mixer applied to a counter: consecutive outputs differ in about half their bits.
    scene::Random random(1, 2);
    double sum = 0.0;
    int changed_bits = 0;
    std::uint64_t last = random.next();
    constexpr int kDraws = 10000;
    for (int i = 0; i < kDraws; ++i) {
        const std::uint64_t next = random.next();
        changed_bits += std::popcount(last ^ next);
        last = next;
        const double unit = random.unit();
        CHECK(unit >= 0.0);
        CHECK(unit < 1.0);
        sum += unit;
    }
    CHECK(std::abs(sum / kDraws - 0.5) < 5.0 / std::sqrt(12.0 * kDraws));  // 5 deviations of the mean
    CHECK(std::abs(static_cast<double>(changed_bits) / kDraws - 32.0) < 5.0 * 4.0 / std::sqrt(1.0 * kDraws));
}
