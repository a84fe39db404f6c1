// Bodies that pass through others: in one step, the centre of one of their shapes crosses a shape of another body from
// one side to the other. A shape contains its centre, so that such shapes must have overlapped on the way.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/health/health_check.hpp"
#include "scene/model/display.hpp"
#include "tumble/cast.hpp"

namespace tumble::scene {

namespace {

constexpr double kLeastPath = 0.01;   // of the thickness of the body: a slower one is pressed through, a deep overlap
constexpr double kThroughPart = 0.5;  // of the thickness of the other shape: less grazes a corner
constexpr double kStraight = 0.1;     // rad: a motion that turns less in the step is taken for a straight line

Vec2 centroid_of(const Shape& shape) { return mass_properties(shape).center; }

class TunnellingCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        if (view.is_first()) return;
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            // A body that hit something in the step did not move along a straight line.
            if (!body.exists || !body.is_awake || !view.was_there(i) || body.is_hit) continue;
            for (const ShapeId shape : view.world().shapes(body.id))
                if (!view.world().is_sensor(shape)) observe_shape(view, i, shape);
        }
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void observe_shape(const HealthView& view, std::size_t i, ShapeId shape) {
        const World& world = view.world();
        const SeenBody& body = view.bodies()[i];
        const Vec2 middle = centroid_of(world.shape(shape));
        const DVec2 from = transform_point(view.bodies_before()[i].state.pose, middle);
        const DVec2 to = transform_point(body.state.pose, middle);
        if (length(to - from) < kLeastPath * body.smallest) return;
        // A shape beside the centre of mass of a body that turns moves along an arc.
        if (length(to - body.center) > kLeastPath * body.smallest && turn_of(view, i) > kStraight) return;
        const DVec2 lower{std::min(from.x, to.x), std::min(from.y, to.y)};
        const DVec2 upper{std::max(from.x, to.x), std::max(from.y, to.y)};
        for (const ShapeId other :
             world.overlap_box(lower, upper, {.shape = world.filter(shape), .except = body.id, .sensors = false}))
            if (may_stop(view, body.id, other)) test_crossing(view, i, middle, other);
    }

    // In the step (rad), at most half a turn.
    static double turn_of(const HealthView& view, std::size_t body) {
        const Rotation before = view.bodies_before()[body].state.pose.rotation;
        const double turn = std::abs(angle(view.bodies()[body].state.pose.rotation) - angle(before));
        return std::min(turn, 2.0 * kPi - turn);
    }

    // Joints keep two bodies from colliding unless they collide while connected.
    static bool may_stop(const HealthView& view, BodyId body, ShapeId other) {
        const BodyId owner = view.world().body(other);
        if (!view.knows(owner) || !view.was_there(view.index_of(owner))) return false;
        return std::ranges::none_of(view.world().joints(body), [&](JointId joint) {
            return std::visit(
                [&](const auto& def) {
                    if (def.body_a != owner && def.body_b != owner) return false;
                    if constexpr (requires { def.collide_connected; }) return !def.collide_connected;
                    return true;
                },
                view.world().joint(joint));
        });
    }

    void test_crossing(const HealthView& view, std::size_t i, Vec2 middle, ShapeId other) {
        const std::size_t k = view.index_of(view.world().body(other));
        const Pose &before = view.bodies_before()[k].state.pose, &now = view.bodies()[k].state.pose;
        if (turn_of(view, k) > kStraight) return;
        const DVec2 from = inverse_transform_point(before, transform_point(view.bodies_before()[i].state.pose, middle));
        const DVec2 to = inverse_transform_point(now, transform_point(view.bodies()[i].state.pose, middle));
        const Shape& shape = view.world().shape(other);
        const CastResult enters = cast_ray(shape, {}, from, to - from), leaves = cast_ray(shape, {}, to, from - to);
        if (enters.status != CastStatus::hit || leaves.status != CastStatus::hit) return;
        const double inside = (1.0 - enters.fraction - leaves.fraction) * length(to - from);
        if (inside < kThroughPart * double{extent(shape).smaller} || passes_open_side(view, k, other, from, to)) return;
        note(view, i, k, length(to - from));
    }

    // The segments of a one-sided chain let pass what comes from their left.
    bool passes_open_side(const HealthView& view, std::size_t body, ShapeId other, DVec2 from, DVec2 to) {
        const std::vector<bool>& flags = one_sided_.try_emplace(body).first->second;
        const std::span<const ShapeId> shapes = view.world().shapes(view.bodies()[body].id);
        if (flags.empty()) one_sided_[body] = find_one_sided(view, body);
        const auto index = static_cast<std::size_t>(std::ranges::find(shapes, other) - shapes.begin());
        const std::vector<bool>& known = one_sided_[body];
        if (index >= known.size() || !known[index]) return false;
        const Shape& segment = view.world().shape(other);
        return cross(DVec2(segment.vertex(1)) - DVec2(segment.vertex(0)), to - from) < 0.0;
    }

    // Of each shape of the body, whether it is a segment of a one-sided chain.
    static std::vector<bool> find_one_sided(const HealthView& view, std::size_t body) {
        std::vector<bool> flags;
        for (const SceneShape& shape : source_of(view.scene(), view.built().bodies[body]).shapes) {
            const auto* const chain = std::get_if<ChainGeometry>(&shape.geometry);
            flags.insert(flags.end(), make_shapes(shape.geometry).size(), chain && !chain->two_sided);
        }
        return flags;
    }

    void note(const HealthView& view, std::size_t i, std::size_t k, double path) {
        const SeenBody& body = view.bodies()[i];
        const Culprit culprit{{i, k}, {view.source(i), view.source(k)}};
        if (!culprits_.is_worst(culprit, path / body.smallest)) return;
        culprits_.set(culprit,
                      {.check = "tunnelling",
                       .subject = view.name(i) + " and " + view.name(k),
                       .text = view.name(i) + " passes through " + view.name(k) + " in one step: it moves " +
                               brief(path) + " m relative to it, and is " + brief(body.smallest) + " m thick",
                       .remedy = "Set \"continuous\": true and \"impacts\": \"in_order\" in the world, or use more "
                                 "\"steps_per_second\".",
                       .step = view.step(),
                       .time = view.world().time(),
                       .bodies = {body.id, view.bodies()[k].id},
                       .point = body.center,
                       .value = path,
                       .limit = body.smallest,
                       .unit = "m"});
    }

    std::map<std::size_t, std::vector<bool>> one_sided_;  // by built body
    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_tunnelling_check() { return std::make_unique<TunnellingCheck>(); }

}  // namespace tumble::scene
