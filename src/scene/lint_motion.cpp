// Tunnelling: continuous collision keeps bodies from passing through what is static or kinematic, and bullets through each
// other too. What it looks at is the way of a step, so that the thickness of a body is the measure.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "scene/display.hpp"
#include "scene/lint.hpp"
#include "scene/names.hpp"

namespace tumble::scene {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kMostTurn = 0.25 * kPi;  // in a step, of bodies that may not turn faster

double thickness_of(const SceneBody& body) {
    double least = HUGE_VAL;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry))
            if (!shape.sensor) least = std::min(least, width_of(part));
    return least;
}

// How far the farthest point of the body is from a point of it (m).
double reach_of(const SceneBody& body, Vec2 from) {
    double reach = 0.0;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry)) reach = std::max(reach, double{farthest_distance(part, from)});
    return reach;
}

class MotionLinter {
public:
    MotionLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene), built_(built), diagnostics_(diagnostics), names_(scene) {
        const auto is_dynamic = [&](const SceneInstance& body) { return built.world.type(body.id) == BodyType::dynamic_body; };
        moving_ = std::ranges::count_if(built.bodies, is_dynamic);
        // One more stands for all that come.
        moving_ += std::ranges::any_of(scene.timeline, [](const SceneEvent& event) { return event.spawn && event.spawn->type == BodyType::dynamic_body; });
    }

    void check_body(const SceneBody& body, const std::string& pointer) { check_velocity(body, body.velocity, pointer + "/velocity"); }

    void note_joint(const SceneJointInstance& joint) {
        const std::optional<SceneJointMotor>& motor = scene_.joints[joint.source].motor;
        if (motor) note_speed(joint, motor->speed, "/joints/" + std::to_string(joint.source) + "/motor");
    }

    void check_event(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = find_definition(scene_, names_, event.body);
        if (body && event.velocity) check_velocity(*body, *event.velocity, pointer + "/velocity");
        const auto joint = std::ranges::find(built_.joints, event.joint, &SceneJointInstance::name);
        if (event.motor_speed && joint != built_.joints.end()) note_speed(*joint, *event.motor_speed, pointer + "/motor_speed");
        if (event.spawn) check_body(*event.spawn, pointer + "/spawn");
    }

    // Of all joints and events that were noted.
    void check_motors() {
        for (const auto& [source, motor] : fastest_) check_motor(*motor.joint, motor.speed, motor.pointer);
    }

private:
    // The fastest that a motor is told to be, and where.
    struct Motor {
        const SceneJointInstance* joint = nullptr;
        double speed = 0.0;
        std::string pointer;
    };

    void note_speed(const SceneJointInstance& joint, double speed, const std::string& pointer) {
        Motor& fastest = fastest_[joint.source];
        if (!fastest.joint || std::abs(speed) > std::abs(fastest.speed)) fastest = {&joint, speed, pointer};
    }

    // Whether another body than `own` many may come in the way of one that is not swept against it.
    bool may_pass(const SceneBody& body, std::ptrdiff_t own) const {
        return body.type == BodyType::dynamic_body && moving_ > own && !body.bullet;
    }

    void check_velocity(const SceneBody& body, DVec2 velocity, const std::string& pointer) {
        const double way = length(velocity) / scene_.world.steps_per_second, thickness = thickness_of(body);
        if (body.type != BodyType::dynamic_body || !(way > thickness)) return;
        if (!may_pass(body, 1) && scene_.world.continuous) return;
        const std::string what = scene_.world.continuous ? "moving bodies" : "whatever is in its way, as the world is not continuous";
        diagnostics_.warning(pointer, "is " + brief(way) + " m in a step, of a body " + brief(thickness) + " m thick: it may pass through " + what,
                             R"("bullet": true, or more steps_per_second)");
    }

    // Of the body that the motor moves: the second one, unless that cannot be moved.
    void check_motor(const SceneJointInstance& joint, double speed, const std::string& pointer) {
        std::visit(
            [&](const auto& def) {
                if constexpr (requires { def.motor->speed; }) {
                    const bool moves_b = built_.world.type(def.body_b) == BodyType::dynamic_body;
                    constexpr bool turns = std::is_same_v<std::decay_t<decltype(*def.motor)>, AngularMotor>;
                    check_driven(moves_b ? def.body_b : def.body_a, moves_b ? def.anchor_b : def.anchor_a, turns, speed, pointer);
                }
            },
            built_.world.joint(joint.id));
    }

    void check_driven(BodyId id, Vec2 anchor, bool turns, double speed, const std::string& pointer) {
        const auto driven = std::ranges::find(built_.bodies, id, &SceneInstance::id);
        const SceneBody& body = scene_.bodies[driven->source];
        const double rate = scene_.world.steps_per_second, thickness = thickness_of(body);
        const double turn = std::min(std::abs(speed) * kDegree / rate, body.allow_fast_rotation ? HUGE_VAL : kMostTurn);
        const double way = turns ? turn * reach_of(body, anchor) : std::abs(speed) / rate;
        if (!(way > thickness) || !may_pass(body, 1)) return;
        const std::string name = display_name(built_, id);
        diagnostics_.warning(pointer, "moves " + name + " by up to " + brief(way) + " m in a step, and it is " + brief(thickness) +
                                          " m thick: it may pass through moving bodies",
                             R"("bullet": true on )" + name + " and on what it shall hit, or more steps_per_second");
    }

    const Scene& scene_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    BodyNames names_;
    std::ptrdiff_t moving_ = 0;              // dynamic bodies
    std::map<std::size_t, Motor> fastest_;  // of joints of the scene
};

}  // namespace

void add_motion_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    MotionLinter linter(scene, built, diagnostics);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) linter.check_body(scene.bodies[i], "/bodies/" + std::to_string(i));
    for (const SceneJointInstance& joint : built.joints) linter.note_joint(joint);
    for (std::size_t i = 0; i < scene.timeline.size(); ++i) linter.check_event(scene.timeline[i], "/timeline/" + std::to_string(i));
    linter.check_motors();
}

}  // namespace tumble::scene
