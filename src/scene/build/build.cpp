// Bodies and joints are created in the order of the file, because the order of creation is part of the simulation. Only
// gears come last, as they are made of other joints.
#include "scene/build/build.hpp"

#include <stdexcept>

#include "debug/check.hpp"
#include "scene/build/element.hpp"
#include "scene/build/validate.hpp"
#include "scene/model/repeat.hpp"

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
    def.joints = settings.joints;
    def.impacts = settings.impacts;
    def.scale = static_cast<float>(settings.scale);
    return def;
}

class Builder {
public:
    Builder(const Scene& scene, const ResolvedScene& resolved, Start start)
        : scene_(scene), resolved_(resolved), start_(start), result_{World(make_world_def(scene.world)), {}, {}} {
        TUMBLE_CHECK(resolved.plans.size() == scene.bodies.size());
        TUMBLE_CHECK(resolved.joints.size() == scene.joints.size());
    }

    // To be called for all bodies, in order.
    void add_bodies(std::size_t source) {
        const SceneBody& body = scene_.bodies[source];
        BodyPlan plan = resolved_.plans[source];
        if (start_ == Start::at_rest) {
            plan.def.awake = true;
            plan.def.velocity = {};
            plan.def.angular_velocity = 0.0f;
        }
        const auto count = static_cast<std::size_t>(copy_count(body));
        for (std::size_t copy = 0; copy < count; ++copy) {
            const Pose& pose = resolved_.placed.at(result_.bodies.size()).pose;
            result_.bodies.push_back({create_body(result_.world, plan, pose), source, copy_name(body, copy)});
        }
    }

    // To be called for all joints but gears, in order, then for all gears.
    void add_joints(std::size_t source) {
        const SceneJoint& joint = scene_.joints[source];
        TUMBLE_CHECK(resolved_.joint_names.built_index({source, 0, 1, false}) == result_.joints.size());
        const std::vector<JointCopy>& copies = resolved_.joints[source];
        for (std::size_t copy = 0; copy < copies.size(); ++copy) {
            const JointId id = result_.world.create_joint(with_ids(copies[copy]));
            result_.joints.push_back({id, source, copy_name(joint, copy)});
        }
    }

    SceneWorld take() { return std::move(result_); }

private:
    JointDef with_ids(const JointCopy& copy) const {
        JointDef joint = copy.def;
        std::visit(
            [&](auto& def) {
                if constexpr (requires { def.joint_a; }) {
                    def.joint_a = result_.joints.at(copy.a).id;
                    def.joint_b = result_.joints.at(copy.b).id;
                } else {
                    def.body_a = result_.bodies.at(copy.a).id;
                    def.body_b = result_.bodies.at(copy.b).id;
                }
            },
            joint);
        return joint;
    }

    const Scene& scene_;
    const ResolvedScene& resolved_;
    const Start start_;
    SceneWorld result_;
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

SceneWorld build_world(const Scene& scene, const ResolvedScene& resolved, Start start, Diagnostics& diagnostics) {
    std::optional<Builder> builder;
    report_refusal(diagnostics, "/world", [&] { builder.emplace(scene, resolved, start); });
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        report_refusal(diagnostics, element("/bodies", i), [&] { builder->add_bodies(i); });
    for (const bool is_gear : {false, true})
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            if ((scene.joints[i].type == SceneJointType::gear) == is_gear)
                report_refusal(diagnostics, element("/joints", i), [&] { builder->add_joints(i); });
    return builder->take();
}

}  // namespace scene

SceneWorld build_world(const Scene& scene) {
    scene::Diagnostics diagnostics(scene.name.empty() ? "scene" : scene.name, "");
    if (!scene.include.empty())
        diagnostics.error("/include", "lists files that were not loaded: such a scene can only be written",
                          "load the scene without keep_includes");
    const std::optional<scene::ResolvedScene> resolved =
        scene::validate_scene(scene, scene::sizes_of(scene), diagnostics);
    diagnostics.finish(nullptr);
    return scene::build_world(scene, resolved.value(), scene::Start::as_written, diagnostics);
}

}  // namespace tumble
