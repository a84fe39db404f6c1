// A claim is decided by the worst moment that it covers: the finding keeps that moment, so that a report can say how
// near a claim that holds came to failing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "scene/json_text.hpp"
#include "scene/names.hpp"
#include "tumble/scene_run.hpp"

namespace tumble {

namespace {

using scene::number_text;

constexpr double kRestSpeed = 0.05;  // m/s: below it the stepper lets bodies fall asleep
constexpr double kSlack = 1e-6;      // of a step: times are decimal fractions, steps are not
constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

std::uint64_t first_step_at(double time, double steps_per_second) {
    return static_cast<std::uint64_t>(std::max(0.0, std::ceil(time * steps_per_second - kSlack)));
}

// Three digits are enough to read, and do not pretend more.
std::string brief(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string point_text(DVec2 point) { return "[" + brief(point.x) + ", " + brief(point.y) + "]"; }

std::string name_of(const SceneWorld& built, std::size_t body) {
    const std::string& name = built.bodies[body].name;
    return name.empty() ? "body[" + std::to_string(body) + "]" : "'" + name + "'";
}

std::string name_of(const SceneWorld& built, BodyId id) {
    const auto found = std::ranges::find(built.bodies, id, &SceneInstance::id);
    return name_of(built, static_cast<std::size_t>(found - built.bodies.begin()));
}

double reach_of(const World& world, BodyId body) {
    float reach = 0.0f;
    for (const ShapeId shape : world.shapes(body))
        reach = std::max(reach, farthest_distance(world.shape(shape), world.mass(body).center));
    return reach;
}

std::string claim_text(const SceneExpectation& expectation) {
    if (expectation.at_rest_by) return "everything is at rest from " + number_text(*expectation.at_rest_by) + " s on";
    if (expectation.max_penetration) return "no overlap is deeper than " + number_text(*expectation.max_penetration) + " m";
    const auto& [lower, upper] = *expectation.inside;
    const std::string time = expectation.at ? "at " + number_text(*expectation.at) + " s" : "at the end";
    return "'" + expectation.body + "' is inside " + point_text(lower) + " to " + point_text(upper) + " " + time;
}

}  // namespace

ExpectationWatch::ExpectationWatch(const Scene& scene, const SceneWorld& built) : scene_(scene) {
    for (const SceneInstance& body : built.bodies) reach_.push_back(reach_of(built.world, body.id));
    const scene::BodyNames names(scene);
    const double rate = built.world.def().steps_per_second;
    for (const SceneExpectation& expectation : scene.expect) {
        Claim claim;
        claim.to = kForever;
        if (expectation.at_rest_by) claim.from = first_step_at(*expectation.at_rest_by, rate);
        if (expectation.inside) {
            claim.body = names.find(expectation.body).value();
            if (expectation.at) claim.from = claim.to = first_step_at(*expectation.at, rate);
        }
        claims_.push_back(claim);
    }
}

void ExpectationWatch::observe(const SceneWorld& built) {
    const std::uint64_t step = built.world.step_count();
    for (std::size_t i = 0; i < claims_.size(); ++i) {
        Claim& claim = claims_[i];
        if (step < claim.from || step > claim.to) continue;
        const SceneExpectation& expectation = scene_.expect[i];
        if (expectation.at_rest_by) observe_rest(claim, built);
        if (expectation.max_penetration) observe_depth(claim, *expectation.max_penetration, built);
        if (expectation.inside) observe_place(claim, *expectation.inside, built);
        claim.seen = true;
    }
}

void ExpectationWatch::observe_rest(Claim& claim, const SceneWorld& built) const {
    for (std::size_t i = 0; i < built.bodies.size(); ++i) {
        const BodyId id = built.bodies[i].id;
        if (built.world.type(id) != BodyType::dynamic_body || !built.world.is_awake(id)) continue;
        const BodyState state = built.world.state(id);
        const double speed = length(state.velocity) + std::abs(double{state.angular_velocity}) * reach_[i];
        if (speed <= claim.worst) continue;
        claim.worst = speed;
        claim.failed = speed >= kRestSpeed;
        claim.finding = name_of(built, i) + " moves at " + brief(speed) + " m/s";
        claim.step = built.world.step_count();
    }
}

void ExpectationWatch::observe_depth(Claim& claim, double limit, const SceneWorld& built) const {
    for (const ContactPoint& contact : built.world.contacts()) {
        const double depth = -double{contact.separation};
        if (depth <= claim.worst) continue;
        claim.worst = depth;
        claim.failed = depth > limit;
        claim.finding = name_of(built, contact.body_a) + " and " + name_of(built, contact.body_b) + " overlap by " +
                        brief(depth) + " m at " + point_text(contact.point);
        claim.step = built.world.step_count();
    }
}

void ExpectationWatch::observe_place(Claim& claim, const std::pair<DVec2, DVec2>& box, const SceneWorld& built) const {
    const DVec2 position = built.world.state(built.bodies[claim.body].id).pose.position;
    const bool inside = position.x >= box.first.x && position.x <= box.second.x && position.y >= box.first.y &&
                        position.y <= box.second.y;
    claim.failed = !inside;
    claim.finding = "it is at " + point_text(position);
    claim.step = built.world.step_count();
}

std::vector<ExpectationResult> ExpectationWatch::results() const {
    std::vector<ExpectationResult> results;
    for (std::size_t i = 0; i < claims_.size(); ++i) {
        const Claim& claim = claims_[i];
        ExpectationResult result{claim.seen && !claim.failed, claim_text(scene_.expect[i]), claim.finding, claim.step};
        if (!claim.seen) result.finding = "the run ends before that";
        results.push_back(result);
    }
    return results;
}

}  // namespace tumble
