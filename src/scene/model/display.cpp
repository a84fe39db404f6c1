#include "scene/model/display.hpp"

#include <algorithm>
#include <cstdio>

namespace tumble::scene {

namespace {

template <class Instance>
std::string quoted_name(const std::vector<Instance>& instances, std::size_t index) {
    const std::string name = output_name(instances[index], index);
    return instances[index].name.empty() ? name : "'" + name + "'";
}

}  // namespace

std::string display_name(const SceneWorld& built, std::size_t body) { return quoted_name(built.bodies, body); }

std::string display_joint_name(const SceneWorld& built, std::size_t joint) { return quoted_name(built.joints, joint); }

std::string display_name(const SceneWorld& built, BodyId id) {
    const auto found = std::ranges::find(built.bodies, id, &SceneInstance::id);
    return display_name(built, static_cast<std::size_t>(found - built.bodies.begin()));
}

std::string brief(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string brief(DVec2 point) { return "[" + brief(point.x) + ", " + brief(point.y) + "]"; }

}  // namespace tumble::scene
