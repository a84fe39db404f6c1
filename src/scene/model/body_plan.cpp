#include "scene/model/body_plan.hpp"

#include "debug/check.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/geometry.hpp"
#include "tumble/chain.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

CollisionFilter make_filter(const SceneShape& shape) {
    if (!shape.filter) return {};
    return {shape.filter->category, shape.filter->mask, shape.filter->group};
}

// A link for each segment of a chain; empty for other shapes.
std::vector<ChainLink> make_links(const ShapeGeometry& geometry) {
    const ChainGeometry* chain = std::get_if<ChainGeometry>(&geometry);
    if (!chain) return {};
    std::vector<Vec2> points;
    for (const DVec2 point : chain->points) points.push_back(to_float(point));
    return make_chain_links(points, chain->loop, !chain->two_sided);
}

}  // namespace

BodyDef make_body_def(const SceneBody& body) {
    BodyDef def;
    def.type = body.type;
    def.velocity = to_float(body.velocity + DVec2{});  // + 0 turns -0, which JSON text does not keep, into 0
    def.angular_velocity = static_cast<float>(body.angular_velocity * kRadians + 0.0);
    def.linear_damping = static_cast<float>(body.linear_damping);
    def.angular_damping = static_cast<float>(body.angular_damping);
    def.gravity_scale = static_cast<float>(body.gravity_scale);
    def.bullet = body.bullet;
    def.awake = body.awake;
    def.locks = {body.lock_x, body.lock_y, body.fixed_rotation};
    def.enabled = body.enabled;
    def.allow_sleep = body.allow_sleep;
    def.allow_fast_rotation = body.allow_fast_rotation;
    if (body.mass)
        def.mass = BodyMass{static_cast<float>(body.mass->mass), to_float(body.mass->center),
                            static_cast<float>(body.mass->inertia)};
    return def;
}

void append_shape_defs(const Scene& scene, const SceneShape& shape, std::vector<ShapeDef>& defs) {
    const std::vector<Shape> parts = make_shapes(shape.geometry);
    const std::vector<ChainLink> links = make_links(shape.geometry);
    TUMBLE_CHECK((links.empty() || links.size() == parts.size()));
    const SceneMaterial* material = find_material(scene, shape.material);
    const SurfaceMaterial surface = make_surface(material ? *material : SceneMaterial{});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        defs.push_back({parts[i], surface, make_filter(shape), shape.sensor, {}});
        if (!links.empty()) defs.back().link = links[i];
    }
}

BodyPlan plan_body(const Scene& scene, const SceneBody& body) {
    BodyPlan plan{make_body_def(body), {}};
    for (const SceneShape& shape : body.shapes) append_shape_defs(scene, shape, plan.shapes);
    return plan;
}

BodyId create_body(World& world, const BodyPlan& plan, const Pose& pose) {
    BodyDef def = plan.def;
    def.pose = pose;
    return world.create_body(def, plan.shapes);
}

}  // namespace tumble::scene
