// Each check names its rule; pointers are those of the file that the scene came from, or would be written to.
#include "scene/build/check.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "scene/build/check_claim.hpp"
#include "scene/format/fields.hpp"
#include "scene/json/json_text.hpp"
#include "scene/model/geometry.hpp"
#include "scene/model/joint_copies.hpp"
#include "scene/model/joint_keys.hpp"
#include "scene/model/names.hpp"
#include "scene/model/place.hpp"
#include "scene/model/repeat.hpp"
#include "tumble/scene_world.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

std::string at(const std::string& list, std::size_t index) { return list + '/' + std::to_string(index); }

class Checker {
public:
    Checker(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics)
        : scene_(scene), own_(own), diagnostics_(diagnostics) {}

    void run() {
        bodies_unread_ = diagnostics_.has_errors_in("/bodies");
        if (!check_counts()) return;
        const BodyNames names(scene_);
        const References references(scene_, names, bodies_unread_, diagnostics_);
        for (std::size_t i = 0; i < own_.bodies; ++i) check_body(scene_.bodies[i], at("/bodies", i));
        check_unique(names);
        check_spawned_names(names);
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) check_places(i);
        for (std::size_t i = 0; i < own_.joints; ++i)
            check_joint(scene_.joints[i], at("/joints", i), names, references);
        for (std::size_t i = 0; i < own_.timeline; ++i)
            check_event(scene_.timeline[i], at("/timeline", i), names, references);
        check_beats();
        for (std::size_t i = 0; i < own_.expect; ++i)
            check_expectation(scene_.expect[i], at("/expect", i), references, diagnostics_);
        if (!scene_.camera.follow.empty()) references.any_body(scene_.camera.follow, "/camera", "follow");
    }

private:
    void error(const std::string& pointer, const std::string& message, const std::string& hint = "") {
        diagnostics_.error(pointer, message, hint);
    }

    // The later checks count copies: false if there are too many to go on.
    bool check_counts() {
        const auto is_within_limit = [this](const auto& list, const std::string& what) {
            std::int64_t total = 0;
            for (std::size_t i = 0; i < list.size(); ++i) {
                const std::int64_t count = copy_count(list[i]);
                total += std::max<std::int64_t>(count, 0);
                if (count >= 0 && total <= kMaxBodies) continue;
                error(at("/" + what, i), "makes " + std::to_string(total) + " " + what +
                                             " with those before; at most " + std::to_string(kMaxBodies) +
                                             " are allowed");
                return false;
            }
            return true;
        };
        return is_within_limit(scene_.bodies, "bodies") && is_within_limit(scene_.joints, "joints");
    }

    void check_body(const SceneBody& body, const std::string& pointer) {
        for (std::size_t i = 0; i < body.shapes.size(); ++i) check_shape(body.shapes[i], at(pointer + "/shapes", i));
        const bool moves = body.velocity != DVec2{} || body.angular_velocity != 0.0;
        if (moves && !body.awake && body.type == BodyType::dynamic_body)
            error(pointer + "/awake", "a body asleep is at rest, and this one has a velocity",
                  R"(leave out "awake": false, or the velocity)");
    }

    void check_shape(const SceneShape& shape, const std::string& pointer) {
        if (diagnostics_.has_errors_in(pointer)) return;
        const std::string kind(alternative_name(shape.geometry));
        try {
            make_shapes(shape.geometry);
            if (const auto* polygon = std::get_if<PolygonGeometry>(&shape.geometry))
                report_hull(*polygon, pointer + "/polygon/vertices");
        } catch (const std::invalid_argument& cause) {
            error(pointer + '/' + kind, cause.what());
        }
        if (shape.material.empty() || find_material(scene_, shape.material) || diagnostics_.has_errors_in("/materials"))
            return;
        std::vector<std::string_view> names;
        for (const SceneMaterial& material : scene_.materials) names.push_back(material.name);
        error(pointer + "/material", "there is no material " + quoted(shape.material),
              names.empty()
                  ? "\"materials\": {" + quoted(shape.material) + ": {\"friction\": 0.9}} beside \"bodies\" declares it"
                  : suggestion(shape.material, names));
    }

    void report_hull(const PolygonGeometry& polygon, const std::string& pointer) {
        HullReport report;
        make_hull(polygon, &report);
        if (report.interior > 0)
            diagnostics_.warning(
                pointer, std::to_string(report.interior) + " of the vertices lie inside the hull and are left out",
                "an outline keeps a concave shape");
        if (report.duplicate + report.collinear > 0)
            diagnostics_.warning(pointer, std::to_string(report.duplicate + report.collinear) +
                                              " of the vertices are duplicate or on an edge and are left out");
    }

    static std::string prefix_hint(std::size_t index, std::size_t own) {
        return index < own ? "" : R"(a "prefix" tells the names of included files apart)";
    }

    void check_unique(const BodyNames& names) {
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            const SceneBody& body = scene_.bodies[i];
            if (body.name.empty()) continue;
            const std::string pointer = at("/bodies", i) + "/name";
            const std::size_t first = *names.find_source(body.name);
            if (first != i)
                error(pointer,
                      quoted(body.name) + " is the name of " + diagnostics_.name_of(at("/bodies", first)) + " already",
                      prefix_hint(i, own_.bodies));
            else if (!body.repeat && names.is_copy(body.name))
                error(pointer, quoted(body.name) + " is the name of a copy of a repeated body");
        }
        std::set<std::string, std::less<>> joint_names, repeated;
        for (const SceneJoint& joint : scene_.joints)
            if (joint.repeat) repeated.insert(joint.name);
        for (std::size_t i = 0; i < scene_.joints.size(); ++i) {
            const std::string& name = scene_.joints[i].name;
            if (copy_number(name) && repeated.contains(base_name(name)))
                error(at("/joints", i) + "/name", quoted(name) + " is a name for copies of a repeated joint");
            if (!name.empty() && !joint_names.insert(name).second)
                error(at("/joints", i) + "/name", quoted(name) + " is the name of another joint already",
                      prefix_hint(i, own_.joints));
        }
    }

    // A name may be given again once its body was despawned.
    void check_spawned_names(const BodyNames& names) {
        std::map<std::string_view, std::set<double>> ends;  // when bodies of a name go
        std::set<std::string_view> repeated;
        for (const SceneEvent& event : scene_.timeline) {
            if (event.at && !event.despawn.empty()) ends[event.despawn].insert(*event.at);
            if (event.spawn && (event.every || event.spawn->repeat)) repeated.insert(event.spawn->name);
        }
        std::map<std::string_view, std::size_t> last;  // who made one
        for (std::size_t i = 0; i < scene_.timeline.size(); ++i) {
            const SceneEvent& event = scene_.timeline[i];
            if (!event.spawn || event.spawn->name.empty()) continue;
            const std::string& name = event.spawn->name;
            const auto refuse = [&](const std::string& whose, const std::string& hint = "") {
                error(at("/timeline", i) + "/spawn/name", quoted(name) + " is the name of " + whose, hint);
            };
            const auto [earlier, is_new] = last.try_emplace(name, i);
            const std::size_t other = std::exchange(earlier->second, i);
            if (names.find_source(name) || names.is_copy(name))
                refuse("a body that is there from the start", prefix_hint(i, own_.timeline));
            else if (copy_number(name) && repeated.contains(base_name(name)))
                refuse("a copy that comes by itself");
            else if (!is_new && !goes_between(scene_.timeline[other], event, ends[name]))
                refuse("what " + diagnostics_.name_of(at("/timeline", other)) + " makes already",
                       i < own_.timeline ? "what was despawned may come again" : prefix_hint(i, own_.timeline));
        }
    }

    static bool goes_between(const SceneEvent& one, const SceneEvent& other, const std::set<double>& ends) {
        if (!one.at || !other.at || one.spawn->repeat || other.spawn->repeat) return false;
        const auto end = ends.lower_bound(std::min(*one.at, *other.at));
        return end != ends.end() && *end <= std::max(*one.at, *other.at);
    }

    // Keeps the places, which joints need.
    void check_places(std::size_t source) {
        try {
            const std::vector<PlacedBody> copies = place_copies(scene_.bodies[source], scene_.world.seed, source);
            placed_.insert(placed_.end(), copies.begin(), copies.end());
        } catch (const std::invalid_argument& cause) {
            error(at("/bodies", source) + "/repeat", cause.what());
            placed_.resize(placed_.size() + static_cast<std::size_t>(copy_count(scene_.bodies[source])));
        }
    }

    void check_joint(const SceneJoint& joint, const std::string& pointer, const BodyNames& names,
                     const References& references) {
        if (diagnostics_.has_errors_in(pointer)) return;
        check_joint_keys(joint, pointer);
        if (joint.type == SceneJointType::gear) return check_gear(joint, pointer, references);
        if (joint.body_a.empty() && joint.body_b.empty() && diagnostics_.has_errors_in(pointer))
            return;  // it has other keys
        const auto a = references.body(joint.body_a, pointer, "bodies/0"),
                   b = references.body(joint.body_b, pointer, "bodies/1");
        if (!a || !b) return;
        if (*a == *b)
            return error(pointer + "/bodies", "a joint needs two bodies, got " + quoted(joint.body_a) + " twice");
        if (joint.repeat) check_joint_repeat(joint, pointer + "/repeat", names);
        if (diagnostics_.has_errors_in(pointer) || bodies_unread_) return;
        try {
            make_joints(joint, names, placed_);
        } catch (const std::invalid_argument& cause) {
            error(pointer, cause.what());
        }
    }

    void check_gear(const SceneJoint& gear, const std::string& pointer, const References& references) {
        const SceneJoint* const a = check_geared(gear.joint_a, pointer, "joints/0", references);
        const SceneJoint* const b = check_geared(gear.joint_b, pointer, "joints/1", references);
        if (!a || !b || diagnostics_.has_errors_in(pointer)) return;
        const NamedPlace first = *references.joint_names().find(gear.joint_a),
                         second = *references.joint_names().find(gear.joint_b);
        if (first == second)
            error(pointer + "/joints", "a gear needs two joints, got " + quoted(gear.joint_a) + " twice");
        if (gear.repeat) check_gear_repeat(gear, pointer + "/repeat", {first, second});
    }

    const SceneJoint* check_geared(const std::string& name, const std::string& pointer, const std::string& key,
                                   const References& references) {
        const SceneJoint* const joint = references.joint(name, pointer, key);
        if (joint && joint->type != SceneJointType::revolute && joint->type != SceneJointType::prismatic)
            error(pointer + '/' + key, "a gear is on revolute and prismatic joints, and " + quoted(name) + " is none");
        return joint;
    }

    void check_gear_repeat(const SceneJoint& gear, const std::string& pointer,
                           std::initializer_list<NamedPlace> joints) {
        if (std::ranges::none_of(joints, &NamedPlace::is_copy))
            return error(pointer, "belongs to gears on repeated joints", "name the first copy: \"hinge[0]\"");
        if (!check_rows(*gear.repeat, pointer)) return;
        for (const NamedPlace& joint : joints)
            if (joint.is_copy && joint.copy + last_step(gear) >= joint.count)
                error(pointer, "needs " + std::to_string(last_step(gear)) + " copies after " +
                                   quoted(copy_name(scene_.joints[joint.source], joint.copy)) + ", there are " +
                                   std::to_string(joint.count - 1 - joint.copy));
    }

    bool check_rows(const JointRepeat& repeat, const std::string& pointer) {
        if (repeat.rows == 1 || repeat.row_step >= repeat.columns) return true;
        error(pointer, "has rows that tie the same copies again", "\"row_step\" is at least the number of columns");
        return false;
    }

    void check_joint_repeat(const SceneJoint& joint, const std::string& pointer, const BodyNames& names) {
        if (!names.is_copy(joint.body_a) && !names.is_copy(joint.body_b))
            return error(pointer, "belongs to joints of repeated bodies", "name the first copy: \"plank[0]\"");
        if (!check_rows(*joint.repeat, pointer)) return;
        for (const std::string* body : {&joint.body_a, &joint.body_b}) {
            const std::size_t needed = last_step(joint), there = names.copies_after(*body).value_or(needed);
            if (needed > there)
                error(pointer, "needs " + std::to_string(needed) + " copies after " + quoted(*body) + ", there are " +
                                   std::to_string(there));
        }
    }

    void check_joint_keys(const SceneJoint& joint, const std::string& pointer) {
        const bool is_distance = joint.type == SceneJointType::distance,
                   is_pulley = joint.type == SceneJointType::pulley;
        const auto refuse = [&](bool present, const std::string& key, const std::string& reason) {
            if (present) error(pointer + '/' + key, reason);
        };
        refuse(is_distance && joint.anchor.has_value(), "anchor", "a distance joint needs 'anchors', one in each body");
        for (const JointKey& key : joint_keys(joint))
            refuse(key.is_there && !key.belongs_to(joint.type), std::string(key.name), key.owners());
        refuse(is_distance && joint.limits && joint.limits->lower < 0.0, "limits", "a distance is at least 0");
        refuse(is_pulley && joint.ratio && !(*joint.ratio > 0.0), "ratio", "must be greater than 0");
        refuse(!is_pulley && joint.ratio && *joint.ratio == 0.0, "ratio", "must not be 0");
        if (is_pulley && !joint.ground_anchors)
            error(pointer, "the key 'ground_anchors' is missing: the wheels that the rope runs over");
        if (is_pulley && !joint.anchors)
            error(pointer, "the key 'anchors' is missing: the ends of the rope, one in each body");
        if (joint.type == SceneJointType::filter || joint.type == SceneJointType::gear || is_pulley) return;
        if (joint.anchor.has_value() == joint.anchors.has_value())
            error(pointer, "needs one of the keys anchor, anchors");
        const bool has_axis = joint.type == SceneJointType::prismatic || joint.type == SceneJointType::wheel;
        if (has_axis && !joint.axis) error(pointer, "the key 'axis' is missing: the direction of the free motion");
        if (!joint.motor) return;
        const bool slides = is_distance || joint.type == SceneJointType::prismatic;
        refuse(slides && !joint.motor->max_force, "motor", "slides: its strength is 'max_force', in N");
        refuse(!slides && !joint.motor->max_torque, "motor", "turns: its strength is 'max_torque', in N m");
    }

    // Of included events too: their own scene may have had shorter steps.
    void check_beats() {
        const double dt = 1.0 / scene_.world.steps_per_second;
        for (std::size_t i = 0; i < scene_.timeline.size(); ++i) {
            const std::string pointer = at("/timeline", i);
            const std::optional<double>& every = scene_.timeline[i].every;
            if (every && *every < dt && !diagnostics_.has_errors_in(pointer))
                error(pointer + "/every", "is shorter than a step of " + number_text(dt) + " s");
        }
    }

    void check_event(const SceneEvent& event, const std::string& pointer, const BodyNames& names,
                     const References& references) {
        if (diagnostics_.has_errors_in(pointer)) return;
        const bool lasts = event.force || event.torque;
        const bool on_body =
            lasts || event.impulse || event.angular_impulse || event.velocity || event.angular_velocity;
        const bool on_joint = event.motor_speed || event.target;
        if (event.every && (lasts || !event.despawn.empty() || !event.release.empty()))
            error(pointer + "/every", "belongs to what can happen again: a force lasts, what is gone cannot go again");
        if (event.from && !event.every) error(pointer + "/from", "belongs to events with 'every'");
        if (event.from && event.until && *event.until < *event.from)
            error(pointer + "/until", "must not be before 'from'");
        if (event.until && !event.every && !lasts)
            error(pointer + "/until", "belongs to events with 'every', and to forces");
        if (event.until && event.at && *event.until <= *event.at) error(pointer + "/until", "must be after 'at'");
        if (on_body) references.any_body(event.body, pointer, "body");
        if (const SceneBody* body = on_body ? find_definition(scene_, names, event.body) : nullptr)
            check_new_velocity(event, pointer, *body);
        if (!on_body && !event.body.empty()) error(pointer + "/body", "belongs to impulses, forces and velocities");
        if (!event.despawn.empty()) references.any_body(event.despawn, pointer, "despawn");
        if (on_joint) check_joint_event(event, pointer, references);
        if (!on_joint && !event.joint.empty()) error(pointer + "/joint", "belongs to motor speeds and targets");
        if (!event.release.empty()) references.joint(event.release, pointer, "release");
        if (event.spawn) check_spawn(*event.spawn, pointer + "/spawn");
    }

    // The world refuses it.
    void check_new_velocity(const SceneEvent& event, const std::string& pointer, const SceneBody& body) {
        if (!event.velocity && !event.angular_velocity) return;
        if (body.type == BodyType::static_body)
            error(pointer + "/body", quoted(event.body) + " is static: it has no velocity",
                  R"("type": "kinematic" moves by its velocity alone)");
        else if (!body.enabled)
            error(pointer + "/body", quoted(event.body) + " is not enabled: it has no velocity");
    }

    void check_joint_event(const SceneEvent& event, const std::string& pointer, const References& references) {
        const SceneJoint* joint = references.joint(event.joint, pointer, "joint");
        if (joint == nullptr) return;
        if (event.motor_speed && !joint->motor)
            error(pointer + "/joint", "the joint " + quoted(event.joint) + " has no motor");
        if (event.target && joint->type != SceneJointType::mouse)
            error(pointer + "/joint", "only a mouse joint has a target, and " + quoted(event.joint) + " is none");
    }

    void check_spawn(const SceneBody& body, const std::string& pointer) {
        check_body(body, pointer);
        if (copy_count(body) > kMaxBodies)
            return error(pointer + "/repeat", "makes " + std::to_string(copy_count(body)) + " bodies; at most " +
                                                  std::to_string(kMaxBodies) + " are allowed");
        try {
            place_copies(body, scene_.world.seed, 0);
        } catch (const std::invalid_argument& cause) {
            error(pointer + "/repeat", cause.what());
        }
    }

    const Scene& scene_;
    const SceneSizes own_;
    Diagnostics& diagnostics_;
    bool bodies_unread_ = false;      // names and places may be missing
    std::vector<PlacedBody> placed_;  // [built bodies]
};

}  // namespace

SceneSizes sizes_of(const Scene& scene) {
    return {scene.materials.size(), scene.bodies.size(), scene.joints.size(), scene.timeline.size(),
            scene.expect.size()};
}

void check_scene(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics) {
    Checker(scene, own, diagnostics).run();
}

}  // namespace tumble::scene
