// Structures that stand by friction alone: an arch and a card house.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double kDegree = kPi / 180.0;

// The largest distance of a body from its initial position.
double farthest_moved(const World& world, const std::vector<BodyId>& bodies, const std::vector<DVec2>& positions) {
    double displacement = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        displacement = std::max(displacement, length(world.state(bodies[i]).pose.position - positions[i]));
    return displacement;
}

struct Building {
    World world;
    std::vector<BodyId> bodies;
    std::vector<DVec2> positions;

    void add(DVec2 position, const Shape& shape, const SurfaceMaterial& material, double turn) {
        bodies.push_back(add_dynamic(world, position, shape, material, turn));
        positions.push_back(position);
    }
};

// Wedges of 180 / 13 degrees between radii of 5.3 and 6.7 m, from the right to the left.
Building make_arch(float friction) {
    constexpr int kStones = 13;
    constexpr double kInner = 5.3, kOuter = 6.7, kMiddle = 6.0, kHalf = 0.5 * kPi / kStones;
    const auto corner = [&](double radius, double side) {
        return to_float({radius * std::cos(kHalf) - kMiddle, side * radius * std::sin(kHalf)});
    };
    const Vec2 corners[] = {corner(kInner, -1.0), corner(kOuter, -1.0), corner(kOuter, 1.0), corner(kInner, 1.0)};
    const Shape stone = make_polygon(corners);
    Building arch;
    add_floor(arch.world, {.friction = friction});
    for (int i = 0; i < kStones; ++i) {
        const double at = (2.0 * i + 1.0) * kHalf;
        arch.add({kMiddle * std::cos(at), kMiddle * std::sin(at)}, stone, {.density = 2.5f, .friction = friction}, at);
    }
    return arch;
}

// Cards of 1 m and 3 cm that lean on each other at 20 degrees from upright, flat ones between the storeys.
Building make_card_house(int storeys) {
    constexpr double kLean = 20.0 * kDegree, kThickness = 0.03, kGap = 5e-4, kSpacing = 0.8;
    const double rise = 0.5 * std::cos(kLean) + 0.5 * kThickness * std::sin(kLean);   // of a card's middle
    const double reach = 0.5 * std::sin(kLean) + 0.5 * kThickness * std::cos(kLean);  // to the card it leans on
    const SurfaceMaterial paper{.density = 0.5f, .friction = 0.6f};
    const Shape card = make_box({static_cast<float>(kThickness), 1.0f});
    const Shape flat = make_box({static_cast<float>(kSpacing - 0.01), static_cast<float>(kThickness)});
    Building house;
    add_floor(house.world);
    for (int storey = 0; storey < storeys; ++storey) {
        const double foot = storey * (2.0 * rise + kThickness);
        for (int pair = 0; pair < storeys - storey; ++pair) {
            const double x = kSpacing * (pair - 0.5 * (storeys - storey - 1));
            house.add({x - reach - kGap, foot + rise}, card, paper, -kLean);
            house.add({x + reach + kGap, foot + rise}, card, paper, kLean);
            if (pair + 1 < storeys - storey)
                house.add({x + 0.5 * kSpacing, foot + 2.0 * rise + 0.5 * kThickness}, flat, paper, 0.0);
        }
    }
    return house;
}

}  // namespace

TEST_CASE("an arch stands by friction, and falls without it") {
    // With the two frictions the thrust may be up to 35 degrees off a joint's normal, or up to 6.
    for (const float friction : {0.7f, 0.1f}) {
        CAPTURE(friction);
        Building arch = make_arch(friction);
        run(arch.world, 600);
        const double moved = farthest_moved(arch.world, arch.bodies, arch.positions);
        if (friction > 0.5f) {
            CHECK(moved < 0.02);  // 14 joints that yield by a millimetre or so each
            CHECK(arch.world.counters().awake_bodies == 0);
        } else {
            CHECK(moved > 1.0);
        }
    }
}

TEST_CASE("a card house of three storeys stands") {
    Building house = make_card_house(3);
    run(house.world, 600);
    CHECK(farthest_moved(house.world, house.bodies, house.positions) < 0.03);  // a card's thickness
    CHECK(house.world.counters().awake_bodies == 0);
}
