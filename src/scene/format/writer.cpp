// The canonical text of a scene, and the hash of its simulated part.
#include "scene/format/writer.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "scene/format/writer_visitor.hpp"
#include "scene/json/json_text.hpp"
#include "tumble/scene_file.hpp"

namespace tumble {

namespace scene {

Json write_scene(const Scene& scene, bool with_defaults) { return Writer(with_defaults, scene.draws).write(scene); }

namespace {

template <class Visitor>
void for_each_body(Scene& scene, Visitor&& visit) {
    for (SceneBody& body : scene.bodies) visit(body);
    for (SceneEvent& event : scene.timeline)
        if (event.spawn) visit(*event.spawn);
}

Scene simulated_part(Scene scene) {
    leave_out_remarks(scene);
    scene.name.clear();
    scene.camera = {};
    for (SceneMaterial& material : scene.materials) material.color.clear();
    for_each_body(scene, [](SceneBody& body) {
        body.trail = body.skin = false;
        body.images.clear();
    });
    return scene;
}

}  // namespace

}  // namespace scene

void leave_out_remarks(Scene& scene) {
    for (std::string* text : {&scene.schema, &scene.description, &scene.custom}) text->clear();
    scene.expect.clear();
    scene.draws.clear();
    scene::for_each_body(scene, [](SceneBody& body) {
        body.custom.clear();
        for (SceneShape& shape : body.shapes) shape.custom.clear();
    });
    for (SceneJoint& joint : scene.joints) joint.custom.clear();
}

std::string to_json(const Scene& scene) { return scene::pretty_text(scene::write_scene(scene)); }

std::uint64_t scene_hash(const Scene& scene) {
    const std::string text = scene::compact_text(scene::write_scene(scene::simulated_part(scene)));
    return XXH64(text.data(), text.size(), 0);
}

}  // namespace tumble
