#include "tools/claims/claim_marks.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tumble::tools {

namespace {

constexpr double kWide = 1e4;  // m: half the extent to which the band of a `height` claim is drawn

bool is_called(const std::string& built_name, const std::string& name) {
    return !name.empty() && (built_name == name || built_name.starts_with(name + "["));
}

// The corners of a rectangle in the claim's own frame, in world coordinates.
std::array<DVec2, 4> corners_of(const SceneExpectation& expected, DVec2 lower, DVec2 upper) {
    const SceneFrame frame = expected.frame.value_or(SceneFrame{});
    const Pose pose{frame.position, make_rotation_degrees(frame.angle)};
    std::array<DVec2, 4> corners{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
    for (DVec2& corner : corners) corner = transform_point(pose, corner);
    return corners;
}

void mark_regions(const SceneExpectation& expected, Marking& marking) {
    for (const std::optional<SceneBox>& box : {expected.inside, expected.outside, expected.region})
        if (box) marking.regions.push_back(corners_of(expected, box->first, box->second));
    if (const std::optional<SceneInterval>& height = expected.height)
        marking.regions.push_back(
            corners_of(expected, {-kWide, std::max(height->lower, -kWide)}, {kWide, std::min(height->upper, kWide)}));
}

// The names of bodies and joints in the claim.
std::vector<std::string> names_in(const SceneExpectation& expected) {
    std::vector<std::string> names{expected.body, expected.touches, expected.never_touches, expected.joint};
    for (const std::string& condition : {expected.that, expected.before})
        if (!condition.empty())
            for (std::string& name : names_in_expression(condition)) names.push_back(std::move(name));
    return names;
}

void mark_named(const SceneExpectation& expected, const SceneWorld& built, Marking& marking) {
    const std::vector<std::string> names = names_in(expected);
    const auto is_named = [&](const std::string& built_name) {
        return std::ranges::any_of(names, [&](const std::string& name) { return is_called(built_name, name); });
    };
    for (const SceneInstance& body : built.bodies)
        if (is_named(body.name)) marking.bodies.push_back(body.id);
    for (const SceneJointInstance& joint : built.joints) {
        if (!is_named(joint.name) || !built.world.is_valid(joint.id)) continue;
        std::visit(
            [&](const auto& def) {
                marking.bodies.insert(marking.bodies.end(), {def.body_a, def.body_b});
            },
            built.world.joint(joint.id));
    }
}

void mark_deepest_overlap(const World& world, Marking& marking) {
    const std::vector<ContactPoint> contacts = world.contacts();
    const auto deepest = std::ranges::min_element(contacts, {}, &ContactPoint::separation);
    if (deepest != contacts.end()) marking.bodies = {deepest->body_a, deepest->body_b};
}

void mark_awake(const World& world, Marking& marking) {
    for (const BodyId body : world.awake_bodies())
        if (world.type(body) == BodyType::dynamic_body) marking.bodies.push_back(body);
}

}  // namespace

Marking marks_of(const SceneExpectation& expected, const ExpectationResult& result, const SceneWorld& built) {
    Marking marking;
    marking.caption = {"expected that " + result.claim, result.finding};
    mark_regions(expected, marking);
    mark_named(expected, built, marking);
    if (expected.max_penetration) mark_deepest_overlap(built.world, marking);
    if (expected.at_rest_by) mark_awake(built.world, marking);
    return marking;
}

}  // namespace tumble::tools
