#include "scene/display.hpp"

#include <algorithm>
#include <cstdio>

namespace tumble::scene {

std::string display_name(const SceneWorld& built, std::size_t body) {
    const std::string& name = built.bodies[body].name;
    return name.empty() ? "body[" + std::to_string(body) + "]" : "'" + name + "'";
}

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
