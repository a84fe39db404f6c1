// The canonical text of a scene, and the hash of its simulated part.
#include "scene/format/writer.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "scene/format/writer_visitor.hpp"
#include "scene/json/json_text.hpp"

namespace tumble {

namespace scene {

Json write_scene(const Scene& scene, bool with_defaults) { return Writer(with_defaults, scene.draws).write(scene); }

namespace {

void leave_out_unsimulated(SceneBody& body) {
    body.custom.clear();
    body.trail = body.skin = false;
    body.images.clear();
    for (SceneShape& shape : body.shapes) shape.custom.clear();
}

Scene simulated_part(Scene scene) {
    for (std::string* text : {&scene.schema, &scene.name, &scene.description, &scene.custom}) text->clear();
    scene.camera = {};
    scene.expect.clear();
    scene.draws.clear();
    for (SceneMaterial& material : scene.materials) material.color.clear();
    for (SceneBody& body : scene.bodies) leave_out_unsimulated(body);
    for (SceneJoint& joint : scene.joints) joint.custom.clear();
    for (SceneEvent& event : scene.timeline)
        if (event.spawn) leave_out_unsimulated(*event.spawn);
    return scene;
}

}  // namespace

}  // namespace scene

std::string to_json(const Scene& scene) { return scene::pretty_text(scene::write_scene(scene)); }

std::uint64_t scene_hash(const Scene& scene) {
    const std::string text = scene::compact_text(scene::write_scene(scene::simulated_part(scene)));
    return XXH64(text.data(), text.size(), 0);
}

}  // namespace tumble
