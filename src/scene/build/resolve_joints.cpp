#include "scene/build/resolve_joints.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "scene/build/element.hpp"
#include "scene/build/references.hpp"
#include "scene/build/validate_joint_keys.hpp"
#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

class JointResolver {
public:
    JointResolver(const Scene& scene, const ResolvedScene& resolved, Diagnostics& diagnostics)
        : scene_(scene), resolved_(resolved), references_(scene, resolved, diagnostics), diagnostics_(diagnostics) {}

    // Empty if the joint has errors.
    std::vector<JointCopy> resolve(const SceneJoint& joint, const std::string& pointer) {
        if (diagnostics_.has_errors_in(pointer)) return {};
        validate_joint_keys(joint, pointer, diagnostics_);
        return joint.type == SceneJointType::gear ? resolve_gear(joint, pointer) : resolve_of_bodies(joint, pointer);
    }

private:
    std::vector<JointCopy> resolve_of_bodies(const SceneJoint& joint, const std::string& pointer) {
        const bool has_no_body = joint.body_a.empty() && joint.body_b.empty();
        if (has_no_body && diagnostics_.has_errors_in(pointer)) return {};  // it has the keys of another type
        const auto a = references_.body(joint.body_a, pointer, "bodies/0"),
                   b = references_.body(joint.body_b, pointer, "bodies/1");
        if (!a || !b) return {};
        if (*a == *b) {
            error(pointer + "/bodies", "a joint needs two bodies, got " + quoted(joint.body_a) + " twice");
            return {};
        }
        if (joint.repeat) validate_repeat(joint, pointer + "/repeat");
        if (diagnostics_.has_errors_in(pointer) || resolved_.bodies_unread) return {};
        try {
            return make_joints(joint, resolved_.body_names, resolved_.placed);
        } catch (const std::invalid_argument& cause) {
            error(pointer, cause.what());
            return {};
        }
    }

    std::vector<JointCopy> resolve_gear(const SceneJoint& gear, const std::string& pointer) {
        const bool has_a = is_geared(gear.joint_a, pointer, "joints/0"),
                   has_b = is_geared(gear.joint_b, pointer, "joints/1");
        if (!has_a || !has_b || diagnostics_.has_errors_in(pointer)) return {};
        const NamedCopy a = *resolved_.joint_names.find(gear.joint_a), b = *resolved_.joint_names.find(gear.joint_b);
        if (a == b) error(pointer + "/joints", "a gear needs two joints, got " + quoted(gear.joint_a) + " twice");
        if (gear.repeat) validate_gear_repeat(gear, pointer + "/repeat", {a, b});
        if (diagnostics_.has_errors_in(pointer)) return {};
        return make_gears(gear, resolved_.joint_names);
    }

    bool is_geared(const std::string& name, const std::string& pointer, const std::string& key) {
        const SceneJoint* const joint = references_.joint(name, pointer, key);
        if (joint && joint->type != SceneJointType::revolute && joint->type != SceneJointType::prismatic)
            error(pointer + '/' + key, "a gear connects revolute or prismatic joints; " + quoted(name) + " is neither");
        return joint != nullptr;
    }

    void validate_repeat(const SceneJoint& joint, const std::string& pointer) {
        const BodyNames& names = resolved_.body_names;
        if (!names.is_copy(joint.body_a) && !names.is_copy(joint.body_b))
            return error(pointer, "needs a body that is a copy of a repeated body",
                         "name the first copy: \"plank[0]\"");
        if (!has_valid_rows(*joint.repeat, pointer)) return;
        if (joint.repeat->spacing != DVec2{}) {
            if (names.is_copy(joint.body_a) && names.is_copy(joint.body_b))
                error(pointer + "/spacing",
                      "moves the anchor on a body that is not repeated, and both bodies are copies", "leave it out");
            else if (!joint.anchors)
                error(pointer + "/spacing", "needs \"anchors\"",
                      "an \"anchor\" of the world moves with the copies by itself");
        }
        for (const std::string* body : {&joint.body_a, &joint.body_b})
            if (const std::optional<std::size_t> there = names.copies_after(*body))
                require_copies(last_step(joint), *body, *there, pointer);
    }

    void validate_gear_repeat(const SceneJoint& gear, const std::string& pointer,
                              std::initializer_list<NamedCopy> joints) {
        if (std::ranges::none_of(joints, &NamedCopy::is_copy))
            return error(pointer, "needs a joint that is a copy of a repeated joint",
                         "name the first copy: \"hinge[0]\"");
        if (!has_valid_rows(*gear.repeat, pointer)) return;
        if (gear.repeat->spacing != DVec2{}) error(pointer + "/spacing", "a gear has no anchors", "leave it out");
        for (const NamedCopy& joint : joints)
            if (joint.is_copy)
                require_copies(last_step(gear), copy_name(scene_.joints[joint.source], joint.copy),
                               joint.count - 1 - joint.copy, pointer);
    }

    bool has_valid_rows(const JointRepeat& repeat, const std::string& pointer) {
        if (repeat.rows == 1 || repeat.row_step >= repeat.columns) return true;
        error(pointer, "has rows that join the same copies twice",
              "\"row_step\" must be at least the number of columns");
        return false;
    }

    void require_copies(std::size_t needed, const std::string& first, std::size_t there, const std::string& pointer) {
        if (needed > there)
            error(pointer, "needs " + std::to_string(needed) + " copies after " + quoted(first) + "; there are " +
                               std::to_string(there));
    }

    void error(const std::string& pointer, const std::string& message, const std::string& hint = "") {
        diagnostics_.error(pointer, message, hint);
    }

    const Scene& scene_;
    const ResolvedScene& resolved_;
    const References references_;
    Diagnostics& diagnostics_;
};

}  // namespace

void resolve_joints(const Scene& scene, const SceneSizes& own, ResolvedScene& resolved, Diagnostics& diagnostics) {
    JointResolver resolver(scene, resolved, diagnostics);
    resolved.joints.resize(scene.joints.size());
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        if (i >= own.joints && diagnostics.has_errors()) return;
        resolved.joints[i] = resolver.resolve(scene.joints[i], element("/joints", i));
    }
}

}  // namespace tumble::scene
