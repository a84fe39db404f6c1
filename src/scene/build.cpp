// Definitions out of a scene's plain data, in the order of the file: the order of creation is part of the simulation.
#include <stdexcept>

#include "scene/check.hpp"
#include "scene/diagnostics.hpp"
#include "scene/geometry.hpp"
#include "scene/joints.hpp"
#include "scene/names.hpp"
#include "scene/place.hpp"
#include "tumble/scene.hpp"

namespace tumble {

namespace scene {

namespace {

WorldDef make_world_def(const SceneSettings& settings) {
    WorldDef def;
    def.gravity = to_float(settings.gravity);
    def.steps_per_second = static_cast<float>(settings.steps_per_second);
    def.substeps = settings.substeps;
    def.sleeping = settings.sleeping;
    def.continuous = settings.continuous;
    def.scale = static_cast<float>(settings.scale);
    return def;
}

BodyDef make_body_def(const SceneBody& body, const Pose& pose) {
    BodyDef def;
    def.type = body.type;
    def.pose = pose;
    def.velocity = to_float(body.velocity + DVec2{});  // + 0 turns -0, which no file can hold, into 0
    def.angular_velocity = static_cast<float>(body.angular_velocity * (kPi / 180.0) + 0.0);
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

class Builder {
public:
    explicit Builder(const Scene& scene) : scene_(scene), result_{World(make_world_def(scene.world)), {}, {}} {}

    void add_bodies(std::size_t source) {
        const SceneBody& body = scene_.bodies[source];
        const std::vector<ShapeDef> shapes = make_shape_defs(scene_, body);
        std::size_t copy = 0;
        for (PlacedBody placed : place_copies(scene_, source)) {
            const BodyDef def = make_body_def(body, placed.pose);
            placed.id = result_.world.create_body(def);
            for (const ShapeDef& shape : shapes) result_.world.add_shape(placed.id, shape);
            // Shapes move the centre of mass, whose velocity is given, and a turning body's with it.
            if (def.type == BodyType::dynamic_body && def.awake && def.enabled)
                result_.world.set_velocity(placed.id, def.velocity, def.angular_velocity);
            result_.bodies.push_back({placed.id, source, copy_name(body, copy++)});
            placed_.push_back(placed);
        }
    }

    void add_joint(const SceneJoint& joint, const BodyNames& names) {
        const PlacedBody& a = placed_[names.find(joint.body_a).value()];
        const PlacedBody& b = placed_[names.find(joint.body_b).value()];
        result_.joints.push_back(result_.world.create_joint(make_joint(joint, a, b)));
    }

    SceneWorld take() { return std::move(result_); }

private:
    const Scene& scene_;
    SceneWorld result_;
    std::vector<PlacedBody> placed_;
};

// Runs `action`; what the world refuses becomes an error at the pointer.
template <class Action>
void report_refusal(Diagnostics& diagnostics, const std::string& pointer, const Action& action) {
    try {
        action();
    } catch (const std::invalid_argument& refusal) {
        diagnostics.error(pointer, refusal.what());
        diagnostics.finish(nullptr);
    }
}

}  // namespace

}  // namespace scene

SceneWorld build_world(const Scene& scene) {
    scene::Diagnostics diagnostics(scene.name.empty() ? "scene" : scene.name, "");
    scene::check_scene(scene, diagnostics);
    diagnostics.finish(nullptr);
    std::optional<scene::Builder> builder;
    scene::report_refusal(diagnostics, "/world", [&] { builder.emplace(scene); });
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        scene::report_refusal(diagnostics, "/bodies/" + std::to_string(i), [&] { builder->add_bodies(i); });
    const scene::BodyNames names(scene);
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        scene::report_refusal(diagnostics, "/joints/" + std::to_string(i),
                              [&] { builder->add_joint(scene.joints[i], names); });
    return builder->take();
}

}  // namespace tumble
