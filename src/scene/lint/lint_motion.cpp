// Tunnelling: continuous collision keeps bodies from passing through what is static or kinematic, and bullets through
// each other too. What it looks at is the way of a step, so that the thickness of a body is the measure.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/body_plan.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/display.hpp"
#include "scene/model/names.hpp"
#include "tumble/world_limits.hpp"

namespace tumble::scene {

namespace {

double thickness_of(const SceneBody& body) {
    double least = HUGE_VAL;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry))
            if (!shape.sensor) least = std::min(least, width_of(part));
    return least;
}

// How far what sweeps over other places, when the body turns about a point of it, is from there (m): a disc about the
// point sweeps over nothing new.
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
        const auto comes = [](const SceneEvent& event) {
            return event.spawn && event.spawn->type == BodyType::dynamic_body;
        };
        moving_ = std::ranges::count_if(built.bodies, is_dynamic);
        moving_ += std::ranges::any_of(scene.timeline, comes);  // one more stands for all that come
    }

    void check_body(const SceneBody& body, const std::string& pointer) {
        check_velocity(body, body.velocity, pointer);
        check_turning(body, body.angular_velocity, pointer);
    }

    void check_event(const SceneEvent& event, const std::string& pointer) {
        const SceneBody* body = find_definition(scene_, names_, event.body);
        if (body && event.velocity) check_velocity(*body, *event.velocity, pointer);
        if (body && event.angular_velocity) check_turning(*body, *event.angular_velocity, pointer);
        const auto joint = std::ranges::find(built_.joints, event.joint, &SceneJointInstance::name);
        if (event.motor_speed && joint != built_.joints.end())
            note_motor(*joint, *event.motor_speed, pointer + "/motor_speed");
        if (event.spawn) check_body(*event.spawn, pointer + "/spawn");
    }

    void note_joint(const SceneJointInstance& instance) {
        const SceneJoint& joint = scene_.joints[instance.source];
        const std::string pointer = "/joints/" + std::to_string(instance.source);
        if (joint.motor) note_motor(instance, joint.motor->speed, pointer + "/motor");
        if (joint.velocity) note({&instance, false, length(*joint.velocity), pointer + "/velocity"});
        if (joint.angular_velocity) note({&instance, true, *joint.angular_velocity, pointer + "/angular_velocity"});
    }

    // Of all joints and events that were noted.
    void check_drives() {
        for (const auto& [key, drive] : fastest_) check_drive(drive);
    }

private:
    // The fastest that a joint is told to move its bodies, and where.
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

    void check_velocity(const SceneBody& body, DVec2 velocity, const std::string& pointer) {
        check_way(body, way_of(length(velocity)), pointer + "/velocity", "is ");
    }

    void check_turning(const SceneBody& body, double angular_velocity, const std::string& pointer) {
        if (angular_velocity != 0.0)
            check_way(body, way_of_turn(body, angular_velocity, center_of(body)), pointer + "/angular_velocity",
                      "moves its ends by up to ");
    }

    // Of the body that the joint moves: the second one, unless that cannot be moved.
    void check_drive(const Drive& drive) {
        std::visit(
            [&](const auto& def) {
                if constexpr (requires { def.anchor_a; }) {
                    const bool moves_b = built_.world.type(def.body_b) == BodyType::dynamic_body;
                    const BodyId id = moves_b ? def.body_b : def.body_a;
                    const SceneBody& body =
                        scene_.bodies[std::ranges::find(built_.bodies, id, &SceneInstance::id)->source];
                    const double way = drive.turns
                                           ? way_of_turn(body, drive.speed, moves_b ? def.anchor_b : def.anchor_a)
                                           : way_of(drive.speed);
                    check_way(body, way, drive.pointer, "moves " + display_name(built_, id) + " by up to ");
                }
            },
            built_.world.joint(drive.joint->id));
    }

    void check_way(const SceneBody& body, double way, const std::string& pointer, const std::string& moves) {
        const bool is_continuous = scene_.world.continuous;
        const bool may_pass = !is_continuous || (moving_ > 1 && !body.bullet);
        if (body.type != BodyType::dynamic_body || !may_pass) return;
        const double thickness = thickness_of(body);
        if (!(way > thickness)) return;
        const std::string what =
            is_continuous ? "other moving bodies" : "whatever is in its way, as the world is not continuous";
        const std::string remedy =
            is_continuous ? R"("bullet": true, also of what moves as fast towards it, or more steps_per_second)"
                          : R"("continuous": true, or more steps_per_second)";
        diagnostics_.warning(pointer,
                             moves + brief(way) + " m in a step, and the body is " + brief(thickness) +
                                 " m thick: it may pass through " + what,
                             remedy);
    }

    // In a step (m).
    double way_of(double speed) const {
        return std::min(std::abs(speed), double{limits_.max_speed}) / scene_.world.steps_per_second;
    }
    double way_of_turn(const SceneBody& body, double angular_velocity, Vec2 pivot) const {
        if (body.fixed_rotation) return 0.0;
        const double turn = std::abs(angular_velocity) * kRadians / scene_.world.steps_per_second;
        return (body.allow_fast_rotation ? turn : std::min(turn, double{limits_.most_turn})) * reach_of(body, pivot);
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
    std::ptrdiff_t moving_ = 0;                              // dynamic bodies
    std::map<std::pair<std::size_t, bool>, Drive> fastest_;  // by the joint of the scene, and whether it turns
};

}  // namespace

void add_motion_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    MotionLinter linter(scene, built, diagnostics);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        linter.check_body(scene.bodies[i], "/bodies/" + std::to_string(i));
    for (const SceneJointInstance& joint : built.joints) linter.note_joint(joint);
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        linter.check_event(scene.timeline[i], "/timeline/" + std::to_string(i));
    linter.check_drives();
}

}  // namespace tumble::scene
