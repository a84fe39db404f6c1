#include "scene/model/body_plan.hpp"

#include "scene/model/degrees.hpp"
#include "scene/model/geometry.hpp"
#include "tumble/chain.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

BodyDef make_body_def(const SceneBody& body) {
    BodyDef def;
    def.type = body.type;
    def.velocity = to_float(body.velocity + DVec2{});  // + 0 turns -0, which no file can hold, into 0
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

CollisionFilter make_filter(const SceneShape& shape) {
    if (!shape.filter) return {};
    return {shape.filter->category, shape.filter->mask, shape.filter->group};
}

// Of the segments of a chain; none for other shapes.
std::vector<ChainLink> make_links(const ShapeGeometry& geometry) {
    const ChainGeometry* chain = std::get_if<ChainGeometry>(&geometry);
    if (!chain) return {};
    std::vector<Vec2> points;
    for (const DVec2 point : chain->points) points.push_back(to_float(point));
    return make_chain_links(points, chain->loop, !chain->two_sided);
}

std::vector<ShapeDef> make_shape_defs(const Scene& scene, const SceneBody& body) {
    std::vector<ShapeDef> defs;
    for (const SceneShape& shape : body.shapes) {
        const SceneMaterial* material = find_material(scene, shape.material);
        const SurfaceMaterial surface = make_surface(material ? *material : SceneMaterial{});
        const std::vector<ChainLink> links = make_links(shape.geometry);
        std::size_t next = 0;
        for (const Shape& part : make_shapes(shape.geometry)) {
            defs.push_back({part, surface, make_filter(shape), shape.sensor, {}});
            if (!links.empty()) defs.back().link = links[next++];
        }
    }
    return defs;
}

}  // namespace

BodyPlan plan_body(const Scene& scene, const SceneBody& body) {
    return {make_body_def(body), make_shape_defs(scene, body)};
}

BodyId create_body(World& world, const BodyPlan& plan, const Pose& pose) {
    BodyDef def = plan.def;
    def.pose = pose;
    return world.create_body(def, plan.shapes);
}

}  // namespace tumble::scene
