#include "tools/labels/coco_file.hpp"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "tools/cli/output_path.hpp"
#include "tools/machine/build_info.hpp"

namespace tumble::tools {

namespace {

// The two bodies of a joint that has anchors of its own.
std::optional<std::pair<BodyId, BodyId>> bodies_of(const World& world, JointId id) {
    const JointDef& joint = world.joint(id);
    if (std::holds_alternative<GearJointDef>(joint) || !world.joint_anchors(id)) return std::nullopt;
    return std::visit([](const auto& def) { return std::pair{def.body_a, def.body_b}; }, joint);
}

std::string name_of_joint(const Scene& scene, std::size_t source) {
    const std::string& name = scene.joints[source].name;
    return name.empty() ? "joint[" + std::to_string(source) + "]" : name;
}

std::string name_of_category(const Scene& scene, std::size_t source) {
    const bool is_body = source < scene.bodies.size();
    const std::size_t event = source - scene.bodies.size();
    const std::string& name = is_body ? scene.bodies[source].name : scene.timeline[event].spawn->name;
    if (!name.empty()) return name;
    return is_body ? "body[" + std::to_string(source) + "]" : "timeline[" + std::to_string(event) + "]";
}

const char* type_name(BodyType type) {
    return type == BodyType::static_body ? "static" : type == BodyType::kinematic_body ? "kinematic" : "dynamic";
}

DVec2 to_pixel(const LabelledFrame& frame, DVec2 world) {
    const double scale = frame.height / frame.camera.height;
    const DVec2 offset = scale * (world - frame.camera.center);
    return {0.5 * frame.width + offset.x, 0.5 * frame.height - offset.y};
}

// COCO's: 0 out of the frame, 1 covered by another body, 2 visible.
int visibility_of(DVec2 pixel, const Mask& mask, BodyLabel label) {
    if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < mask.width && pixel.y < mask.height)) return 0;
    const auto at =
        static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(pixel.x);
    return mask.labels[at] == 0 || mask.labels[at] == label ? 2 : 1;
}

}  // namespace

CocoFile::CocoFile(const std::filesystem::path& file, bool force, const Scene& scene, const SceneWorld& built)
    : scene_(scene), file_(open_output(file, force)) {
    add_key_points(built);
    file_.write("{\"annotations\": [");
}

// Copies of a body share their category's list: the same joint of each copy has the same slot.
void CocoFile::add_key_points(const SceneWorld& built) {
    std::map<BodyId, std::size_t> bodies;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) bodies[built.bodies[i].id] = i;
    std::map<std::tuple<std::size_t, std::size_t, bool>, std::size_t> used;  // by body, joint of the scene and side
    std::map<std::tuple<std::size_t, std::size_t, bool, std::size_t>, std::size_t> slots;  // by category instead
    for (std::size_t j = 0; j < built.joints.size(); ++j) {
        const SceneJointInstance& joint = built.joints[j];
        const auto ends = bodies_of(built.world, joint.id);
        if (!ends) continue;
        for (const bool is_b : {false, true}) {
            const std::size_t body = bodies.at(is_b ? ends->second : ends->first);
            const std::size_t category = built.bodies[body].source;
            const std::size_t ordinal = used[{body, joint.source, is_b}]++;
            std::vector<std::string>& names = categories_[category];
            const auto [slot, is_new] = slots.try_emplace({category, joint.source, is_b, ordinal}, names.size());
            if (is_new)
                names.push_back(name_of_joint(scene_, joint.source) + (is_b ? ":b" : ":a") +
                                (ordinal > 0 ? "[" + std::to_string(ordinal) + "]" : ""));
            key_points_[body].push_back({j, is_b, slot->second});
        }
    }
}

void CocoFile::add(const SceneWorld& built, const LabelledFrame& frame, const FrameLabels& labels) {
    for (const LabelledBody& body : labels.bodies)
        if (body.visible > 0) add_annotation(built, frame, labels, body);
    json_.clear();
    json_.open_object().member("id", frame.frame).member("file_name", frame.image);
    json_.member("width", frame.width).member("height", frame.height);
    write_frame_members(json_, frame);
    json_.close_object();
    images_ += (images_.empty() ? "\n" : ",\n") + json_.text();
}

void CocoFile::add_annotation(const SceneWorld& built, const LabelledFrame& frame, const FrameLabels& labels,
                              const LabelledBody& body) {
    const std::size_t category = built.bodies[body.label - 1u].source;
    json_.clear();
    json_.open_object().member("id", ++annotations_).member("image_id", frame.frame);
    json_.member("category_id", category + 1).member("label", body.label);
    json_.key("bbox").open_array().value(body.first_column).value(body.first_row);
    json_.value(body.last_column - body.first_column + 1).value(body.last_row - body.first_row + 1).close_array();
    json_.member("area", body.visible).member("iscrowd", 0);
    json_.member("visibility", static_cast<double>(body.visible) / static_cast<double>(body.pixels));
    write_outlines(built, frame, body);
    write_key_points(built, frame, labels.mask, body, category);
    json_.close_object();
    file_.write((annotations_ > 1 ? ",\n" : "\n") + json_.text());
}

// The outlines of the shapes, clipped to the frame, and the box of the whole body.
void CocoFile::write_outlines(const SceneWorld& built, const LabelledFrame& frame, const LabelledBody& body) {
    const World& world = built.world;
    const Pose pose = world.state(body.body).pose;
    Aabb whole;
    json_.key("segmentation").open_array();
    for (const ShapeId id : world.shapes(body.body)) {
        if (world.is_sensor(id)) continue;
        whole = merge(whole, bounds(world.shape(id), pose));
        const std::vector<DVec2> outline =
            frame_outline(world.shape(id), pose, frame.camera, frame.width, frame.height);
        if (outline.size() < 3) continue;
        json_.open_array();
        for (const DVec2 point : outline) json_.value(point.x).value(point.y);
        json_.close_array();
    }
    json_.close_array();
    const DVec2 corner = to_pixel(frame, {double{whole.lower.x}, double{whole.upper.y}});
    const DVec2 far = to_pixel(frame, {double{whole.upper.x}, double{whole.lower.y}});
    json_.key("full_bbox").open_array().value(corner.x).value(corner.y);
    json_.value(far.x - corner.x).value(far.y - corner.y).close_array();
}

void CocoFile::write_key_points(const SceneWorld& built, const LabelledFrame& frame, const Mask& mask,
                                const LabelledBody& body, std::size_t category) {
    std::vector<std::tuple<double, double, int>> points(categories_[category].size());
    int seen = 0;
    for (const KeyPoint& point : key_points_[body.label - 1u]) {
        const JointId joint = built.joints[point.joint].id;
        if (!built.world.is_valid(joint)) continue;
        const JointAnchors anchors = *built.world.joint_anchors(joint);
        const DVec2 pixel = to_pixel(frame, point.is_b ? anchors.b : anchors.a);
        const int visibility = visibility_of(pixel, mask, body.label);
        if (visibility == 0) continue;
        points[point.slot] = {pixel.x, pixel.y, visibility};
        ++seen;
    }
    json_.key("keypoints").open_array();
    for (const auto& [x, y, visibility] : points) json_.value(x).value(y).value(visibility);
    json_.close_array().member("num_keypoints", seen);
}

std::uint64_t CocoFile::finish(const SceneWorld& built) {
    std::map<std::size_t, BodyType> types;
    for (const SceneInstance& body : built.bodies) types.try_emplace(body.source, source_of(scene_, body).type);
    file_.write("],\n\"images\": [" + images_ + "],\n\"categories\": [");
    const char* separator = "\n";
    for (const auto& [source, type] : types) {
        json_.clear();
        json_.open_object().member("id", source + 1).member("name", name_of_category(scene_, source));
        json_.member("supercategory", type_name(type)).member("keypoints", categories_[source]);
        json_.key("skeleton").open_array().close_array().close_object();
        file_.write(separator + json_.text());
        separator = ",\n";
    }
    json_.clear();
    json_.open_object().member("description", scene_.name).member("version", version()).close_object();
    file_.write("],\n\"info\": " + json_.text() + "}\n");
    return file_.commit();
}

}  // namespace tumble::tools
