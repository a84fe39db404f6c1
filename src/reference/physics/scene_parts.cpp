#include "reference/physics/scene_parts.hpp"

#include <utility>

namespace tumble::reference {

namespace {

constexpr const char* kMaterial = "surface";

SceneBody body_of(DVec2 position, ShapeGeometry geometry) {
    SceneBody body;
    body.position = position;
    body.shapes.push_back({.geometry = std::move(geometry), .material = kMaterial, .custom = {}});
    return body;
}

SceneBody of_type(SceneBody body, BodyType type) {
    body.type = type;
    return body;
}

}  // namespace

Scene empty_scene(DVec2 gravity, double friction, double restitution, SceneRate rate) {
    Scene scene;
    scene.name = "physics";
    scene.world.gravity = gravity;
    scene.world.steps_per_second = rate.steps_per_second;
    scene.world.substeps = rate.substeps;
    scene.world.sleeping = false;
    scene.materials.push_back(
        {.name = kMaterial, .density = 1.0, .friction = friction, .restitution = restitution, .color = {}});
    return scene;
}

SceneBody disc(DVec2 position, double radius, DVec2 velocity) {
    SceneBody body = body_of(position, CircleGeometry{.radius = radius, .center = {}});
    body.velocity = velocity;
    return body;
}

SceneBody box(DVec2 position, DVec2 size, double angle) {
    SceneBody body = body_of(position, BoxGeometry{.size = size, .center = {}});
    body.angle = angle;
    return body;
}

SceneBody fixed(SceneBody body) { return of_type(std::move(body), BodyType::static_body); }
SceneBody kinematic(SceneBody body) { return of_type(std::move(body), BodyType::kinematic_body); }

SceneBody ghost(SceneBody body) {
    for (SceneShape& shape : body.shapes) shape.filter = SceneFilter{.mask = 0};
    return body;
}

std::string body_name(int index) { return "b" + std::to_string(index); }

int add(Scene& scene, SceneBody body) {
    const int index = static_cast<int>(scene.bodies.size());
    body.name = body_name(index);
    scene.bodies.push_back(std::move(body));
    return index;
}

int add_floor(Scene& scene, double width) { return add(scene, fixed(box({0.0, -0.5}, {width, 1.0}))); }

void add_walls(Scene& scene, DVec2 middle, double inner) {
    const double at = 0.5 * inner + 0.5;
    for (const double side : {-1.0, 1.0}) {
        add(scene, fixed(box(middle + DVec2{side * at, 0.0}, {1.0, inner + 2.0})));
        add(scene, fixed(box(middle + DVec2{0.0, side * at}, {inner + 2.0, 1.0})));
    }
}

void add_hinge(Scene& scene, int body_a, int body_b, DVec2 at) {
    SceneJoint joint;
    joint.type = SceneJointType::revolute;
    joint.body_a = body_name(body_a);
    joint.body_b = body_name(body_b);
    joint.anchor = at;
    scene.joints.push_back(std::move(joint));
}

void add_rod(Scene& scene, int body_a, int body_b, DVec2 anchor_a) {
    SceneJoint joint;
    joint.type = SceneJointType::distance;
    joint.body_a = body_name(body_a);
    joint.body_b = body_name(body_b);
    joint.anchors = std::pair(anchor_a, DVec2{});
    scene.joints.push_back(std::move(joint));
}

}  // namespace tumble::reference
