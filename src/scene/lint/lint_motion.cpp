// Tunnelling. Continuous collision keeps fast bodies from passing through all others if the world's impacts are in
// order. If they are at the end of the step, it keeps them from passing through static and kinematic bodies only, and
// bullets through all others. What is not swept may pass through a body if its displacement in a step exceeds its
// thickness.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/body_plan.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/names.hpp"
#include "tumble/world_def.hpp"

namespace tumble::scene {

namespace {

double thickness_of(const SceneBody& body) {
    double least = HUGE_VAL;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry))
            if (!shape.sensor) least = std::min(least, width_of(part));
    return least;
}

// The farthest distance from the pivot at which a rotation about it moves the surface of the body (m). The radius of a
// shape is subtracted: a disc about the pivot sweeps over no new area.
double reach_of(const SceneBody& body, Vec2 pivot) {
    double reach = 0.0;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry))
            if (!shape.sensor) reach = std::max(reach, double{farthest_distance(part, pivot)} - double{part.radius()});
    return reach;
}

class MotionLinter {
public:
    MotionLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene),
          built_(built),
          diagnostics_(diagnostics),
          names_(scene),
          limits_(world_limits(built.world.def())) {
        const auto is_dynamic = [&](const SceneInstance& body) {
            return built.world.type(body.id) == BodyType::dynamic_body;
        };
        const auto is_spawned = [](const SceneEvent& event) {
            return event.spawn && event.spawn->type == BodyType::dynamic_body;
        };
        dynamic_count_ = std::ranges::count_if(built.bodies, is_dynamic);
        dynamic_count_ += std::ranges::any_of(scene.timeline, is_spawned);  // one stands for all that are spawned
    }

    void lint_body(const SceneBody& body, const std::string& pointer) {
        lint_velocity(body, body.velocity, pointer);
        lint_rotation(body, body.angular_velocity, pointer);
    }

    void lint_event(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = find_definition(scene_, names_, event.body);
        if (body && event.velocity) lint_velocity(*body, *event.velocity, pointer);
        if (body && event.angular_velocity) lint_rotation(*body, *event.angular_velocity, pointer);
        const auto joint = std::ranges::find(built_.joints, event.joint, &SceneJointInstance::name);
        if (event.motor_speed && joint != built_.joints.end())
            note_motor(*joint, *event.motor_speed, pointer + "/motor_speed");
        if (event.spawn) lint_body(*event.spawn, pointer + "/spawn");
    }

    void note_joint(const SceneJointInstance& instance) {
        const SceneJoint& joint = scene_.joints[instance.source];
        const std::string pointer = "/joints/" + std::to_string(instance.source);
        if (joint.motor) note_motor(instance, joint.motor->speed, pointer + "/motor");
        if (joint.velocity) note({&instance, false, length(*joint.velocity), pointer + "/velocity"});
        if (joint.angular_velocity) note({&instance, true, *joint.angular_velocity, pointer + "/angular_velocity"});
    }

    // Lints the fastest drive of each joint that was noted.
    void lint_drives() {
        for (const auto& [key, drive] : fastest_) lint_drive(drive);
    }

private:
    // The largest speed at which a joint drives its bodies, and the value that sets it.
    struct Drive {
        const SceneJointInstance* joint = nullptr;
        bool turns = false;
        double speed = 0.0;  // degrees/s if it turns, else m/s
        std::string pointer;
    };

    void note_motor(const SceneJointInstance& joint, double speed, const std::string& pointer) {
        note({&joint, scene_.joints[joint.source].motor->max_torque.has_value(), speed, pointer});
    }

    void note(const Drive& drive) {
        Drive& fastest = fastest_[{drive.joint->source, drive.turns}];
        if (!fastest.joint || std::abs(drive.speed) > std::abs(fastest.speed)) fastest = drive;
    }

    void lint_velocity(const SceneBody& body, DVec2 velocity, const std::string& pointer) {
        lint_displacement(body, displacement_of(length(velocity)), pointer + "/velocity", "the body moves ");
    }

    void lint_rotation(const SceneBody& body, double angular_velocity, const std::string& pointer) {
        if (angular_velocity != 0.0)
            lint_displacement(body, displacement_of_rotation(body, angular_velocity, center_of(body)),
                              pointer + "/angular_velocity", "the rotation moves the ends of the body by up to ");
    }

    // For the body that the joint moves: the second one, or the first if the second one is not dynamic.
    void lint_drive(const Drive& drive) {
        std::visit(
            [&](const auto& def) {
                if constexpr (requires { def.anchor_a; }) {
                    const bool moves_b = built_.world.type(def.body_b) == BodyType::dynamic_body;
                    const BodyId id = moves_b ? def.body_b : def.body_a;
                    const SceneBody& body =
                        scene_.bodies[std::ranges::find(built_.bodies, id, &SceneInstance::id)->source];
                    const double displacement =
                        drive.turns ? displacement_of_rotation(body, drive.speed, moves_b ? def.anchor_b : def.anchor_a)
                                    : displacement_of(drive.speed);
                    lint_displacement(body, displacement, drive.pointer,
                                      "the joint moves " + display_name(built_, id) + " by up to ");
                }
            },
            built_.world.joint(drive.joint->id));
    }

    void lint_displacement(const SceneBody& body, double displacement, const std::string& pointer,
                           const std::string& moves) {
        const bool is_continuous = scene_.world.continuous;
        const bool is_swept_against_all = scene_.world.impacts == ImpactModel::in_order || body.bullet;
        const bool may_pass_through = !is_continuous || (dynamic_count_ > 1 && !is_swept_against_all);
        if (body.type != BodyType::dynamic_body || !may_pass_through) return;
        const double thickness = thickness_of(body);
        if (!(displacement > thickness)) return;
        const std::string what =
            is_continuous ? "other moving bodies" : "anything in its path, because the world is not continuous";
        const std::string remedy =
            is_continuous
                ? R"(set "impacts": "in_order", or "bullet": true on this body and on fast ones that it meets)"
                : R"(set "continuous": true, or use more steps_per_second)";
        diagnostics_.warning(codes::fast_body, pointer,
                             moves + brief(displacement) + " m in a step, and the body is " + brief(thickness) +
                                 " m thick: it may pass through " + what,
                             remedy);
    }

    // Over a step (m).
    double displacement_of(double speed) const {
        return std::min(std::abs(speed), double{limits_.max_speed}) / scene_.world.steps_per_second;
    }
    double displacement_of_rotation(const SceneBody& body, double angular_velocity, Vec2 pivot) const {
        if (body.fixed_rotation) return 0.0;
        const double turn = std::abs(angular_velocity) * kRadians / scene_.world.steps_per_second;
        return (body.allow_fast_rotation ? turn : std::min(turn, double{limits_.max_rotation})) * reach_of(body, pivot);
    }

    // The centre of mass, body coordinates.
    Vec2 center_of(const SceneBody& body) const {
        if (body.mass) return to_float(body.mass->center);
        World alone;
        return alone.mass(alone.create_body({}, plan_body(scene_, body).shapes)).center;
    }

    const Scene& scene_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    BodyNames names_;
    WorldLimits limits_;
    std::ptrdiff_t dynamic_count_ = 0;                       // dynamic bodies
    std::map<std::pair<std::size_t, bool>, Drive> fastest_;  // by the joint of the scene, and whether it turns
};

}  // namespace

void add_motion_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    MotionLinter linter(scene, built, diagnostics);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        linter.lint_body(scene.bodies[i], "/bodies/" + std::to_string(i));
    for (const SceneJointInstance& joint : built.joints) linter.note_joint(joint);
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        linter.lint_event(scene.timeline[i], "/timeline/" + std::to_string(i));
    linter.lint_drives();
}

}  // namespace tumble::scene
