// The counts, sources and output names of the bodies and joints that a scene makes.
#include "scene/model/repeat.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

namespace {

template <class Entry>
std::size_t count_copies(const std::vector<Entry>& entries) {
    std::int64_t count = 0;
    for (const Entry& entry : entries) count += scene::copy_count(entry);
    return static_cast<std::size_t>(count);
}

}  // namespace

std::size_t count_bodies(const Scene& scene) { return count_copies(scene.bodies); }

std::size_t count_joints(const Scene& scene) { return count_copies(scene.joints); }

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

}  // namespace tumble
