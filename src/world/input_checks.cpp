#include "world/input_checks.hpp"

#include <cmath>

#include "world/require.hpp"

namespace tumble {

namespace {

// The largest difference of the length of a rotation (cosine, sine) from 1: far above the rounding of floats, far below
// the effect of a mistake.
constexpr double kUnitTolerance = 1e-4;

}  // namespace

void check(const WorldDef& def) {
    require(is_finite(def.gravity), "gravity", "finite", def.gravity);
    require(std::isfinite(def.steps_per_second) && def.steps_per_second > 0.0f, "steps_per_second",
            "finite and greater than 0", def.steps_per_second);
    require_positive(def.scale, "scale");
    if (def.substeps < 1)
        throw std::invalid_argument("substeps must be at least 1, got " + std::to_string(def.substeps));
    check(def.threads);
}

void check(const Threads& threads) {
    const auto check_not_negative = [](const char* name, int value) {
        if (value < 0)
            throw std::invalid_argument("threads " + std::string(name) + " must not be negative, got " +
                                        std::to_string(value));
    };
    check_not_negative("count", threads.count);
    check_not_negative("least_work", threads.least_work);
}

void check_pose(const Pose& pose, const std::string& owner) {
    require(is_finite(pose.position), (owner + " position").c_str(), "finite", pose.position);
    const Rotation q = pose.rotation;
    const double length = std::sqrt(double{q.c} * q.c + double{q.s} * q.s);
    require(std::abs(length - 1.0) <= kUnitTolerance, (owner + " rotation (cosine, sine)").c_str(), "of length 1",
            Vec2{q.c, q.s});
}

void check(const std::optional<BodyMass>& mass) {
    if (!mass) return;
    require_positive(mass->mass, "body mass");
    require(is_finite(mass->center), "body centre of mass", "finite", mass->center);
    require_not_negative(mass->inertia, "body inertia");
}

void check(const BodyDef& def) {
    check_pose(def.pose, "body");
    check(def.mass);
    check_velocity(def.velocity, def.angular_velocity);
    require_not_negative(def.linear_damping, "body linear_damping");
    require_not_negative(def.angular_damping, "body angular_damping");
    require(std::isfinite(def.gravity_scale), "body gravity_scale", "finite", def.gravity_scale);
    if (!def.awake && def.type == BodyType::dynamic_body)
        require(def.velocity == Vec2{} && def.angular_velocity == 0.0f, "velocity of a body asleep", "0", def.velocity);
}

void check(const Shape& shape) {
    if (shape.vertex_count() < 1) throw std::invalid_argument("shape must have at least 1 vertex, got 0");
    require_not_negative(shape.radius(), "shape radius");
    for (int i = 0; i < shape.vertex_count(); ++i)
        require(is_finite(shape.vertex(i)), "shape vertex", "finite", shape.vertex(i));
}

void check(const ShapeDef& def) {
    check(def.shape);
    for (const Vec2 beside : {def.link.value_or(ChainLink{}).before, def.link.value_or(ChainLink{}).after})
        require(is_finite(beside), "shape link", "finite", beside);
    check(def.material);
}

void check(const SurfaceMaterial& material) {
    require_not_negative(material.density, "shape density");
    require_not_negative(material.friction, "shape friction");
    const float restitution = material.restitution;
    require(restitution >= 0.0f && restitution <= 1.0f, "shape restitution", "between 0 and 1", restitution);
    require_not_negative(material.rolling_resistance, "shape rolling_resistance");
    require(std::isfinite(material.tangent_speed), "shape tangent_speed", "finite", material.tangent_speed);
}

void check_velocity(Vec2 velocity, float angular_velocity) {
    require(is_finite(velocity), "body velocity", "finite", velocity);
    require(std::isfinite(angular_velocity), "body angular_velocity", "finite", angular_velocity);
}

void check_action(Vec2 action, const char* what) { require(is_finite(action), what, "finite", action); }
void check_action(float action, const char* what) { require(std::isfinite(action), what, "finite", action); }
void check_point(DVec2 point) { require(is_finite(point), "point", "finite", point); }

}  // namespace tumble
