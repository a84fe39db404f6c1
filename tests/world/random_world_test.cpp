// Random worlds, edited between steps: no invariant breaks, nothing diverges, and energy stays bounded.
//
// TUMBLE_WORLDS=n runs n worlds instead of a few, from the seed after TUMBLE_WORLDS_FROM on.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/environment.hpp"
#include "support/random_world.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kSteps = 200;

// m/s: the speed limit of a step, and its rounding. Mechanisms whose joints contradict each other reach it.
constexpr float kSpeedBound = 400.0f * (1.0f + 4.0f * 0x1p-24f);

// m/s. Bodies start with up to 10 m/s and fall for 200 steps at up to 2 g: 67 m/s. Impulses add up to 5 m/s each, some
// of them in a row; springs and motors are bounded by a few times that.
constexpr float kOrdinarySpeed = 200.0f;

// Of all worlds; about three in a hundred are torn between joints that contradict each other.
constexpr double kTornWorlds = 0.08;

float fastest(const World& world) {
    float speed = 0.0f;
    for (const BodyId id : world.bodies()) speed = std::max(speed, length(world.state(id).velocity));
    return speed;
}

}  // namespace

TEST_CASE("random worlds that are edited between steps keep every invariant, and stay bounded") {
    const int worlds = from_environment("TUMBLE_WORLDS", 12);
    REQUIRE(worlds > 0);
    const int from = from_environment("TUMBLE_WORLDS_FROM", 1);
    int torn = 0;
    for (int seed = from; seed < from + worlds; ++seed) {
        CAPTURE(seed);
        float top = 0.0f;
        RandomWorld random(static_cast<std::uint32_t>(seed));
        for (int step = 0; step < kSteps; ++step) {
            CAPTURE(step);
            if (step % 3 != 2) random.edit();
            random.world.audit();
            random.world.step();
            random.world.audit();
            REQUIRE(fastest(random.world) <= kSpeedBound);
            top = std::max(top, fastest(random.world));
        }
        torn += top > kOrdinarySpeed;
    }
    CHECK(torn <= 1.0 + kTornWorlds * worlds);
}
