// Sub-steps warm start the bodies if impacts are in order, and the contacts if they are at the end of the step. Both apply
// the same impulses, so that a pile at rest moves in the same way, up to rounding.
#include <doctest/doctest.h>

#include <vector>

#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// A pyramid of 15 boxes, and three boxes on a plank that hangs by two hinges.
std::vector<DVec2> settled_positions(ImpactModel impacts) {
    WorldDef def;
    def.impacts = impacts;
    World world(def);
    add_pyramid(world, 5);
    const BodyId frame = add_static(world, {20.0, 5.0}, make_box({0.1f, 0.1f}));
    std::vector<BodyId> hanging{add_dynamic(world, {20.0, 2.0}, make_box({4.0f, 0.2f}))};
    for (const double x : {18.5, 21.5})
        world.create_joint(DistanceJointDef{.body_a = frame,
                                            .body_b = hanging.front(),
                                            .anchor_a = {static_cast<float>(x) - 20.0f, 0.0f},
                                            .anchor_b = {static_cast<float>(x) - 20.0f, 0.1f},
                                            .length = 2.9f});
    for (const double x : {19.0, 20.0, 21.0}) hanging.push_back(add_dynamic(world, {x, 2.6}, make_box({0.9f, 1.0f})));
    run(world, 30);
    std::vector<DVec2> positions;
    for (const BodyId body : world.bodies()) positions.push_back(world.state(body).pose.position);
    return positions;
}

}  // namespace

TEST_CASE("bodies that are warm started settle as those with contacts that are") {
    const std::vector<DVec2> by_body = settled_positions(ImpactModel::in_order);
    const std::vector<DVec2> by_contact = settled_positions(ImpactModel::at_step_end);
    REQUIRE(by_body.size() == by_contact.size());
    for (std::size_t i = 0; i < by_body.size(); ++i) {
        CAPTURE(i);
        CHECK(length(by_body[i] - by_contact[i]) < 1e-5);  // m; without a warm start the lowest boxes sink by 0.1 m
    }
}
