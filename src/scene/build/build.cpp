// Definitions out of a scene's plain data, in the order of the file: the order of creation is part of the simulation.
// Only gears come last, as they are made of other joints.
#include <stdexcept>

#include "scene/build/build.hpp"
#include "scene/build/check.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/model/body_plan.hpp"
#include "scene/model/joint_copies.hpp"
#include "scene/model/names.hpp"
#include "scene/model/place.hpp"
#include "scene/model/repeat.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

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
    Builder(const Scene& scene, Start start)
        : scene_(scene), start_(start), result_{World(make_world_def(scene.world)), {}, {}} {}

    void add_bodies(std::size_t source) {
        const SceneBody& body = scene_.bodies[source];
        BodyPlan plan = plan_body(scene_, body);
        if (start_ == Start::at_rest) {
            plan.def.awake = true;
            plan.def.velocity = {};
            plan.def.angular_velocity = 0.0f;
        }
        std::size_t copy = 0;
        for (PlacedBody placed : place_copies(body, scene_.world.seed, source)) {
            placed.id = create_body(result_.world, plan, placed.pose);
            result_.bodies.push_back({placed.id, source, copy_name(body, copy++)});
            placed_.push_back(placed);
        }
    }

    void add_joints(std::size_t source, const BodyNames& names) {
        add(source, make_joints(scene_.joints[source], names, placed_));
    }
    void add_gears(std::size_t source, const JointNames& names) {
        add(source, make_gears(scene_.joints[source], names, joints_));
    }

    SceneWorld take() { return std::move(result_); }

private:
    void add(std::size_t source, const std::vector<JointDef>& copies) {
        for (const JointDef& def : copies) {
            const JointId id = result_.world.create_joint(def);
            result_.joints.push_back({id, source, copy_name(scene_.joints[source], joints_[source].size())});
            joints_[source].push_back(id);
        }
    }

    const Scene& scene_;
    const Start start_;
    SceneWorld result_;
    std::vector<PlacedBody> placed_;
    std::vector<std::vector<JointId>> joints_{scene_.joints.size()};  // the copies of each
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

SceneWorld build_world(const Scene& scene, Start start) {
    Diagnostics diagnostics(scene.name.empty() ? "scene" : scene.name, "");
    if (!scene.include.empty())
        diagnostics.error("/include", "is written only: what it includes is not there",
                          "load the scene without keep_includes");
    check_scene(scene, sizes_of(scene), diagnostics);
    diagnostics.finish(nullptr);
    std::optional<Builder> builder;
    report_refusal(diagnostics, "/world", [&] { builder.emplace(scene, start); });
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        report_refusal(diagnostics, "/bodies/" + std::to_string(i), [&] { builder->add_bodies(i); });
    const BodyNames names(scene);
    const JointNames joint_names(scene);
    const auto for_each_joint = [&](bool is_gear, const auto& add) {
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            if ((scene.joints[i].type == SceneJointType::gear) == is_gear)
                report_refusal(diagnostics, "/joints/" + std::to_string(i), [&] { add(i); });
    };
    for_each_joint(false, [&](std::size_t i) { builder->add_joints(i, names); });
    for_each_joint(true, [&](std::size_t i) { builder->add_gears(i, joint_names); });
    return builder->take();
}

}  // namespace scene

SceneWorld build_world(const Scene& scene) { return scene::build_world(scene, scene::Start::as_written); }

const SceneBody& source_of(const Scene& scene, const SceneInstance& body) {
    if (body.source < scene.bodies.size()) return scene.bodies[body.source];
    return scene.timeline.at(body.source - scene.bodies.size()).spawn.value();
}

std::string output_name(const SceneInstance& body, std::size_t index) {
    return body.name.empty() ? "body[" + std::to_string(index) + "]" : body.name;
}

std::string output_name(const SceneJointInstance& joint, std::size_t index) {
    return joint.name.empty() ? "joint[" + std::to_string(index) + "]" : joint.name;
}

std::size_t count_bodies(const Scene& scene) {
    std::int64_t count = 0;
    for (const SceneBody& body : scene.bodies) count += scene::copy_count(body);
    return static_cast<std::size_t>(count);
}

std::size_t count_joints(const Scene& scene) {
    std::int64_t count = 0;
    for (const SceneJoint& joint : scene.joints) count += scene::copy_count(joint);
    return static_cast<std::size_t>(count);
}

}  // namespace tumble
