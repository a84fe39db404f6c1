#include "reference/box2d_v3/v3_world.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "reference/box2d_v3/library/v3_library.hpp"
#include "reference/box2d_v3/v3_joint_plan.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::reference {

namespace {

namespace v3 = box2d_v3;

int type_number(BodyType type) { return type == BodyType::static_body ? 0 : type == BodyType::kinematic_body ? 1 : 2; }

v3::BodyPlan plan_of(const World& world, BodyId id, const SceneBody& source) {
    const BodyState state = world.state(id);
    v3::BodyPlan plan;
    plan.type = type_number(world.type(id));
    const Vec2 position = to_float(state.pose.position);
    plan.pose = {position.x, position.y, state.pose.rotation.c, state.pose.rotation.s};
    plan.velocity_x = state.velocity.x;
    plan.velocity_y = state.velocity.y;
    plan.angular_velocity = state.angular_velocity;
    plan.linear_damping = static_cast<float>(source.linear_damping);
    plan.angular_damping = static_cast<float>(source.angular_damping);
    plan.gravity_scale = static_cast<float>(source.gravity_scale);
    plan.is_awake = world.is_awake(id);
    plan.is_bullet = source.bullet;
    plan.has_fixed_rotation = source.fixed_rotation;
    plan.may_sleep = source.allow_sleep;
    return plan;
}

// The parts of a shape that Box2D can hold: a fan about the first vertex if there are too many.
void add_parts(v3::World* world, int body, const Shape& shape, const v3::Surface& surface) {
    const int count = shape.vertex_count();
    const int part = v3::kMostPoints - 2;  // vertices that each further part adds
    for (int begin = 1; begin == 1 || begin + 1 < count; begin += part) {
        std::vector<float> xy{shape.vertex(0).x, shape.vertex(0).y};
        for (int i = begin; i < std::min(begin + v3::kMostPoints - 1, count); ++i)
            xy.insert(xy.end(), {shape.vertex(i).x, shape.vertex(i).y});
        v3::add_shape(world, body, {xy.data(), static_cast<int>(xy.size() / 2), shape.radius()}, surface);
    }
}

}  // namespace

struct V3World::Impl {
    v3::World* world;
    std::map<BodyId, int> bodies;  // their numbers in that world
    float step_duration;
    int sub_steps;

    explicit Impl(const Scene& scene)
        : world(v3::make_world(static_cast<float>(scene.world.gravity.x), static_cast<float>(scene.world.gravity.y),
                               scene.world.sleeping, scene.world.continuous)),
          step_duration(static_cast<float>(1.0 / scene.world.steps_per_second)),
          sub_steps(scene.world.substeps) {}
    ~Impl() { v3::destroy(world); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void add(const SceneWorld& built, const Scene& scene, const SceneInstance& instance) {
        const World& source = built.world;
        const int body = v3::add_body(world, plan_of(source, instance.id, scene.bodies[instance.source]));
        bodies[instance.id] = body;
        for (const ShapeId id : source.shapes(instance.id)) {
            if (source.is_sensor(id)) continue;
            const SurfaceMaterial& material = source.material(id);
            const CollisionFilter filter = source.filter(id);
            add_parts(world, body, source.shape(id),
                      {material.friction, material.restitution, material.rolling_resistance, material.tangent_speed,
                       filter.category, filter.mask, filter.group});
        }
        const BodyMass mass = source.mass(instance.id);
        if (source.type(instance.id) == BodyType::dynamic_body && mass.mass > 0.0f)
            v3::set_mass(world, body, {mass.mass, mass.center.x, mass.center.y, mass.inertia});
    }

    void add(const JointDef& joint) {
        std::optional<v3::JointPlan> plan = v3_joint_plan(joint);
        if (!plan) return;
        std::visit(
            [&](const auto& def) {
                if constexpr (requires { def.body_a; }) {  // gears join joints
                    plan->body_a = bodies.at(def.body_a);
                    plan->body_b = bodies.at(def.body_b);
                }
            },
            joint);
        v3::add_joint(world, *plan);
    }
};

bool V3World::can_hold(const Scene& scene) {
    if (!scene.timeline.empty()) return false;
    const SceneWorld built = build_world(scene);
    return std::ranges::all_of(built.world.joints(),
                               [&](JointId id) { return v3_joint_plan(built.world.joint(id)).has_value(); });
}

V3World::V3World(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {
    const SceneWorld built = build_world(scene);
    for (const SceneInstance& instance : built.bodies) impl_->add(built, scene, instance);
    for (const JointId id : built.world.joints()) impl_->add(built.world.joint(id));
}
V3World::~V3World() = default;
V3World::V3World(V3World&&) noexcept = default;
V3World& V3World::operator=(V3World&&) noexcept = default;

void V3World::step() { v3::step(impl_->world, impl_->step_duration, impl_->sub_steps); }

Pose V3World::pose(int body) const {
    const v3::Place place = v3::pose_of(impl_->world, body);
    return {{double{place.x}, double{place.y}}, {place.c, place.s}};
}

}  // namespace tumble::reference
