#include "scene/build/resolve.hpp"

#include <algorithm>
#include <stdexcept>

#include "debug/check.hpp"
#include "scene/build/element.hpp"
#include "scene/build/references.hpp"
#include "scene/build/resolve_joints.hpp"
#include "scene/build/validate_names.hpp"
#include "scene/format/fields.hpp"
#include "scene/json/json_text.hpp"
#include "scene/model/geometry.hpp"
#include "scene/model/repeat.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

// False, with an error, if the entries of a list make too many copies. `what` is the list's key.
template <class Entry>
bool are_within_limit(const std::vector<Entry>& list, const std::string& what, Diagnostics& diagnostics) {
    std::int64_t total = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::int64_t count = copy_count(list[i]);
        total += std::max<std::int64_t>(count, 0);
        if (count >= 0 && total <= kMaxBodies) continue;
        diagnostics.error(element("/" + what, i), "brings the number of " + what + " to " + std::to_string(total) +
                                                      "; at most " + std::to_string(kMaxBodies) + " are allowed");
        return false;
    }
    return true;
}

void validate_material(const Scene& scene, const std::string& name, const std::string& pointer,
                       Diagnostics& diagnostics) {
    if (name.empty() || find_material(scene, name) || diagnostics.has_errors_in("/materials")) return;
    std::vector<std::string_view> names;
    for (const SceneMaterial& material : scene.materials) names.push_back(material.name);
    diagnostics.error(pointer, "there is no material " + quoted(name),
                      names.empty()
                          ? "\"materials\": {" + quoted(name) + ": {\"friction\": 0.9}} beside \"bodies\" declares it"
                          : suggestion(name, names));
}

// If a scatter repeater finds no room, all its copies are at the origin: the indices of later bodies stay.
std::vector<PlacedBody> resolve_copies(const Scene& scene, std::size_t source, Diagnostics& diagnostics) {
    const SceneBody& body = scene.bodies[source];
    try {
        return place_copies(body, scene.world.seed, source);
    } catch (const std::invalid_argument& cause) {
        diagnostics.error(element("/bodies", source) + "/repeat", cause.what());
        return std::vector<PlacedBody>(static_cast<std::size_t>(copy_count(body)));
    }
}

}  // namespace

std::vector<ShapeDef> resolve_shapes(const Scene& scene, const SceneBody& body, const std::string& pointer,
                                     Diagnostics& diagnostics) {
    std::vector<ShapeDef> defs;
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        const SceneShape& shape = body.shapes[i];
        const std::string at = element(pointer + "/shapes", i);
        if (diagnostics.has_errors_in(at)) continue;
        try {
            append_shape_defs(scene, shape, defs);
        } catch (const std::invalid_argument& cause) {
            diagnostics.error(at + '/' + std::string(alternative_name(shape.geometry)), cause.what());
        }
        validate_material(scene, shape.material, at + "/material", diagnostics);
    }
    return defs;
}

std::optional<ResolvedScene> resolve(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics) {
    const bool bodies_unread = diagnostics.has_errors_in("/bodies");
    if (!are_within_limit(scene.bodies, "bodies", diagnostics) ||
        !are_within_limit(scene.joints, "joints", diagnostics))
        return std::nullopt;
    ResolvedScene resolved(scene);
    resolved.bodies_unread = bodies_unread;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        resolved.plans.push_back(
            {make_body_def(body), resolve_shapes(scene, body, element("/bodies", i), diagnostics)});
    }
    validate_names(scene, own, resolved.body_names, diagnostics);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const std::vector<PlacedBody> copies = resolve_copies(scene, i, diagnostics);
        TUMBLE_CHECK(static_cast<std::int64_t>(copies.size()) == copy_count(scene.bodies[i]));
        resolved.placed.insert(resolved.placed.end(), copies.begin(), copies.end());
    }
    resolve_joints(scene, own, resolved, diagnostics);
    return resolved;
}

}  // namespace tumble::scene
