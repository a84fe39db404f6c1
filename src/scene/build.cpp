// Definitions out of a scene's plain data, in the order of the file: the order of creation is part of the simulation.
#include <stdexcept>

#include "scene/body_plan.hpp"
#include "scene/check.hpp"
#include "scene/diagnostics.hpp"
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

class Builder {
public:
    explicit Builder(const Scene& scene) : scene_(scene), result_{World(make_world_def(scene.world)), {}, {}} {}

    void add_bodies(std::size_t source) {
        const SceneBody& body = scene_.bodies[source];
        const BodyPlan plan = plan_body(scene_, body);
        std::size_t copy = 0;
        for (PlacedBody placed : place_copies(body, scene_.world.seed, source)) {
            placed.id = create_body(result_.world, plan, placed.pose);
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

const SceneBody& source_of(const Scene& scene, const SceneInstance& body) {
    if (body.source < scene.bodies.size()) return scene.bodies[body.source];
    return scene.timeline.at(body.source - scene.bodies.size()).spawn.value();
}

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
