// Imports R.U.B.E. exports (b2dJson, Chris Campbell): world, bodies, fixtures and joints of a Box2D scene.
//
// Features that a scene cannot express are noted, each once, with a count. The result is read back as a scene file
// before it is returned, so that every imported scene can be saved and loaded.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "import/rube/rube_images.hpp"
#include "import/rube/rube_joints.hpp"
#include "import/rube/rube_mass.hpp"
#include "import/rube/rube_shapes.hpp"
#include "import/rube/rube_values.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/input.hpp"
#include "scene/json/json_text.hpp"
#include "scene/model/degrees.hpp"
#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_import.hpp"

namespace tumble {

namespace scene {

namespace {

constexpr Range kSpin{-kFastest * kRadians, kFastest* kRadians};  // rad/s

class RubeImporter {
public:
    explicit RubeImporter(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    ImportedScene import(const Json& document) {
        RubeObject world(document, "", diagnostics_);
        read_world(world);
        std::vector<RubeObject> bodies = world.list("body");
        for (RubeObject& body : bodies) read_body(body);
        read_joints(world.list("joint"), bodies.size());
        add_images(read_rube_images(world.list("image"), bodies.size(), notes_));
        world.note_unread("world", notes_);
        return {std::move(scene_), notes_.take()};
    }

private:
    void read_world(RubeObject& world) {
        scene_.world.gravity = world.vector("gravity", kAny);
        scene_.world.sleeping = world.flag("allowSleep");
        scene_.world.continuous = world.flag("continuousPhysics");
        const double rate = world.number("stepsPerSecond");
        if (rate > 0.0) scene_.world.steps_per_second = rate;
        if (world.flag("subStepping")) notes_.add("sub-stepping of continuous physics");
        if (!world.flag("warmStarting", true)) notes_.add("warm starting switched off");
        if (!world.flag("autoClearForces", true)) notes_.add("forces that are not cleared");
        scene_.custom = world.custom({"customProperties"});
        // Numbers of iterations are of Box2D's solver, and collisionbitplanes are the editor's names of categories.
        world.skip({"velocityIterations", "positionIterations", "collisionbitplanes"});
    }

    void read_body(RubeObject& body) {
        SceneBody result;
        const double type = body.number("type");
        if (type != 0.0 && type != 1.0 && type != 2.0)
            diagnostics_.error(body.pointer_to("type"), "must be 0, 1 or 2, got " + number_text(type));
        result.type = type == 2.0   ? BodyType::dynamic_body
                      : type == 1.0 ? BodyType::kinematic_body
                                    : BodyType::static_body;
        result.position = body.vector("position", kPosition);
        result.angle = std::remainder(body.number("angle"), 2.0 * kPi) * kDegrees;
        result.velocity = body.vector("linearVelocity", kAny);
        result.angular_velocity = body.number("angularVelocity", 0.0, kSpin) * kDegrees;
        result.linear_damping = body.number("linearDamping", 0.0, kNotNegative);
        result.angular_damping = body.number("angularDamping", 0.0, kNotNegative);
        result.gravity_scale = body.number("gravityScale", 1.0, kAny);
        read_name(body, result);
        for (const RubeObject& fixture : body.list("fixture"))
            if (const std::optional<RubeFixture> read = read_rube_fixture(fixture, owner_of(result), notes_))
                result.shapes.push_back(
                    {read->geometry, material_of(read->surface), read->custom, read->filter, read->sensor});
        read_behavior(body, result);
        body.note_unread("body", notes_);
        scene_.bodies.push_back(std::move(result));
    }

    // Names are unique in a scene: of bodies with the same name, the first keeps it and the others get a number.
    void read_name(RubeObject& body, SceneBody& result) {
        const std::string name = body.text("name");
        result.name = name;
        for (int number = 2; !result.name.empty() && !names_.insert(result.name).second; ++number)
            result.name = name + "_" + std::to_string(number);
        if (result.name != name) notes_.add_of(owner_of(result), "repeated body names, numbered");
        result.custom = body.custom({"customProperties"});
    }

    void read_behavior(RubeObject& body, SceneBody& result) {
        const bool awake = body.flag("awake"), may_sleep = body.flag("allowSleep", true);
        const bool bullet = body.flag("bullet"), fixed = body.flag("fixedRotation");
        result.enabled = body.flag("active", true);
        result.fixed_rotation = fixed && result.type == BodyType::dynamic_body;
        result.mass = read_rube_mass(body, result, owner_of(result), scene_.materials);
        if (result.type != BodyType::dynamic_body) return;
        result.awake = awake;
        if (!awake && (result.velocity != DVec2{} || result.angular_velocity != 0.0)) {
            notes_.add_of(owner_of(result), "velocities of sleeping bodies");
            result.velocity = {};
            result.angular_velocity = 0.0;
        }
        result.bullet = bullet;
        result.allow_sleep = may_sleep;
    }

    // "body 'wheel'", or "body 7" if it is the eighth of the export and has no name. To be called before it is added.
    std::string owner_of(const SceneBody& body) const {
        return "body " + (body.name.empty() ? std::to_string(scene_.bodies.size()) : "'" + body.name + "'");
    }

    // The name of the material with this surface.
    std::string material_of(const RubeSurface& surface) {
        for (const auto& [name, known] : surfaces_)
            if (known == surface) return name;
        SceneMaterial material;
        material.name = "surface_" + std::to_string(scene_.materials.size() + 1);
        material.density = surface.density;
        material.friction = surface.friction;
        material.restitution = surface.restitution;
        surfaces_[material.name] = surface;
        scene_.materials.push_back(material);
        return material.name;
    }

    // Gears last, because they may precede the joints that they couple.
    void read_joints(std::vector<RubeObject> joints, std::size_t body_count) {
        const auto body_at = [this](std::size_t index) {
            const SceneBody& body = scene_.bodies[index];
            return RubeBody{name_body(index), {body.position, make_rotation_degrees(body.angle)}};
        };
        std::vector<std::optional<std::size_t>> indices(joints.size());  // in the scene, of each joint of the export
        std::vector<std::size_t> gears;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const std::string type = joints[i].text("type");
            if (type == "gear")
                gears.push_back(i);
            else
                indices[i] = add_joint(read_rube_joint(joints[i], type, body_count, body_at, notes_));
        }
        const auto joint_at = [&](std::size_t index) { return indices[index] ? name_joint(*indices[index]) : nullptr; };
        for (const std::size_t i : gears) add_joint(read_rube_gear(joints[i], joints.size(), joint_at, notes_));
    }

    // Those of the world are shown by a static body without shapes.
    void add_images(const std::vector<RubeImage>& images) {
        SceneBody world;
        world.type = BodyType::static_body;
        for (const RubeImage& read : images)
            (read.body ? scene_.bodies[*read.body] : world).images.push_back(read.image);
        if (world.images.empty()) return;
        name(world.name, "images_", scene_.bodies.size(), names_);
        scene_.bodies.push_back(std::move(world));
    }

    // Of joints with the same name, the first keeps it and the others get a number.
    std::optional<std::size_t> add_joint(std::optional<SceneJoint> joint) {
        if (!joint) return std::nullopt;
        const std::string name = joint->name;
        for (int number = 2; !joint->name.empty() && !joint_names_.insert(joint->name).second; ++number)
            joint->name = name + "_" + std::to_string(number);
        if (joint->name != name) notes_.add_of("joint '" + joint->name + "'", "repeated joint names, numbered");
        scene_.joints.push_back(std::move(*joint));
        return scene_.joints.size() - 1;
    }

    // Joints refer to bodies, and gears to joints, by name: those without a name get one.
    std::string name_body(std::size_t index) { return name(scene_.bodies[index].name, "body_", index, names_); }
    SceneJoint* name_joint(std::size_t index) {
        name(scene_.joints[index].name, "joint_", index, joint_names_);
        return &scene_.joints[index];
    }

    static std::string name(std::string& own, const std::string& kind, std::size_t index,
                            std::set<std::string>& names) {
        for (int number = 0; own.empty(); ++number) {
            std::string candidate = kind + std::to_string(index) + (number > 0 ? "_" + std::to_string(number) : "");
            if (names.insert(candidate).second) own = candidate;
        }
        return own;
    }

    Diagnostics& diagnostics_;
    RubeNotes notes_;
    Scene scene_;
    std::set<std::string> names_, joint_names_;
    std::map<std::string, RubeSurface> surfaces_;  // by the name of their material
};

}  // namespace

}  // namespace scene

ImportedScene import_rube(const std::filesystem::path& file) {
    return parse_rube(read_file(file, scene::kMaxFileBytes), file.string());
}

std::string rube_json(std::string_view content) {
    std::string result(scene::without_byte_order_mark(content));
    const std::size_t open = result.find('{');
    const std::size_t equals = result.find('=');
    const std::size_t close = result.find_last_not_of("; \t\r\n");
    if (open == std::string::npos || equals >= open || close == std::string::npos || result[close] != '}')
        return result;
    const auto blank = [](char& c) { c = c == '\n' ? '\n' : ' '; };
    std::for_each(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(open), blank);
    std::for_each(result.begin() + static_cast<std::ptrdiff_t>(close) + 1, result.end(), blank);
    return result;
}

ImportedScene parse_rube(std::string_view content, const std::string& file_name) {
    const std::string text = rube_json(content);
    scene::Diagnostics diagnostics(file_name, text);
    ImportedScene imported;
    if (const std::optional<scene::Json> document = scene::parse_json(text, diagnostics)) {
        if (document->is_object() && document->contains("metaworld")) {
            diagnostics.error("/metaworld", "this is a project of the R.U.B.E. editor, not an export",
                              "open it in the editor, export the scene as JSON, and import that file",
                              scene::Diagnostics::At::key);
        } else if (document->is_object() && !document->contains("body") && !document->contains("gravity")) {
            diagnostics.error("", "this is not a R.U.B.E. export: it has neither \"body\" nor \"gravity\"",
                              document->contains("bodies") ? "it seems to be a scene, which needs no import" : "");
        } else {
            imported = scene::RubeImporter(diagnostics).import(*document);
        }
    }
    diagnostics.finish(&imported.warnings);
    const std::filesystem::path file = file_name;
    imported.scene.name = file.stem().string();
    imported.scene.description = "Imported from the R.U.B.E. export " + file.filename().string() + ".";
    imported.scene = parse_scene(to_json(imported.scene), file_name + " (as imported)");
    return imported;
}

}  // namespace tumble
