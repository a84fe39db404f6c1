// Points are moved, vectors rotated, angles added; values in body coordinates stay. Adding 0 turns -0, which JSON text
// does not keep, into 0.
#include "scene/load/place_part.hpp"

#include <cmath>
#include <stdexcept>

#include "scene/claims/claims.hpp"
#include "scene/expressions/program.hpp"
#include "scene/format/fields.hpp"
#include "scene/model/turn.hpp"

namespace tumble::scene {

namespace {

class PartPlacer {
public:
    explicit PartPlacer(const SceneInclude& include) : include_(include), turn_(sin_cos_degrees(include.angle)) {}

    void place(SceneMaterial& material) const { rename(material.name); }

    void place(SceneBody& body) const {
        rename(body.name);
        move(body.position);
        add_angle(body.angle);
        turn(body.velocity);
        if (body.repeat) std::visit([this](auto& repeat) { add_angle(repeat.angle); }, *body.repeat);
        for (SceneShape& shape : body.shapes) rename(shape.material);
        const std::filesystem::path folder = std::filesystem::path(include_.file).parent_path();
        for (SceneImage& image : body.images) image.file = (folder / image.file).lexically_normal().generic_string();
    }

    void place(SceneJoint& joint) const {
        for (std::string* name : {&joint.name, &joint.body_a, &joint.body_b, &joint.joint_a, &joint.joint_b})
            rename(*name);
        if (joint.anchor) move(*joint.anchor);
        if (joint.ground_anchors) move(joint.ground_anchors->first), move(joint.ground_anchors->second);
        if (joint.axis && !joint.anchors) turn(*joint.axis);
        if (joint.velocity) turn(*joint.velocity);
    }

    void place(SceneEvent& event) const {
        for (std::string* name : {&event.body, &event.joint, &event.despawn, &event.release}) rename(*name);
        if (!event.when.empty()) {
            rename_in(event.when);
            place(event.frame);
        }
        if (event.impulse) turn(*event.impulse, kForce);
        if (event.force) turn(*event.force, kForce);
        if (event.velocity) turn(*event.velocity);
        if (event.target) move(*event.target);
        if (event.spawn) place(*event.spawn);
    }

    void place(SceneExpectation& claim) const {
        for (std::string* name : {&claim.body, &claim.joint, &claim.touches, &claim.never_touches}) rename(*name);
        for (std::string* condition : {&claim.that, &claim.before})
            if (!condition->empty()) rename_in(*condition);
        if (can_have_frame(claim)) place(claim.frame);
    }

private:
    void rename(std::string& name) const {
        if (name.empty()) return;
        name.insert(0, include_.prefix);
        if (name.size() > kMaxNameBytes)
            throw std::invalid_argument("the name '" + name + "' is longer than " + std::to_string(kMaxNameBytes) +
                                        " bytes");
    }

    // The names in an expression.
    void rename_in(std::string& text) const {
        text = with_prefix(text, include_.prefix);
        if (text.size() > kMaxExpressionBytes)
            throw std::invalid_argument("makes the expression '" + text + "' longer than " +
                                        std::to_string(kMaxExpressionBytes) + " bytes");
    }

    void place(std::optional<SceneFrame>& placed) const {
        SceneFrame frame = placed.value_or(SceneFrame{});
        move(frame.position);
        add_angle(frame.angle);
        placed = frame;
    }

    void move(DVec2& point) const {
        point = include_.position + turned(point, turn_) + DVec2{};
        require(point, kPosition, "a position");
    }

    void turn(DVec2& vector, const Range& range = kAny) const {
        vector = turned(vector, turn_) + DVec2{};
        require(vector, range, "a velocity, force or direction");
    }

    void add_angle(double& angle) const {
        angle = angle + include_.angle + 0.0;
        require({angle, 0.0}, kAny, "an angle");
    }

    // Both ranges are symmetric.
    static void require(DVec2 v, const Range& range, const char* what) {
        if (!(std::abs(v.x) <= range.max && std::abs(v.y) <= range.max))
            throw std::invalid_argument(std::string("moves ") + what + " out of its range");
    }

    const SceneInclude& include_;
    SinCos turn_;
};

bool is_of_world(const SceneExpectation& claim) {
    const bool has_names = !claim.that.empty() && refers_to_names(claim.that);
    return claim.body.empty() && claim.joint.empty() && !has_names;
}

}  // namespace

void place_part(Scene& part, const SceneInclude& include) {
    std::erase_if(part.timeline, [](const SceneEvent& event) { return event.gravity || event.stop; });
    std::erase_if(part.expect, is_of_world);
    const PartPlacer placer(include);
    for (SceneMaterial& material : part.materials) placer.place(material);
    for (SceneBody& body : part.bodies) placer.place(body);
    for (SceneJoint& joint : part.joints) placer.place(joint);
    for (SceneEvent& event : part.timeline) placer.place(event);
    for (SceneExpectation& claim : part.expect) placer.place(claim);
}

}  // namespace tumble::scene
