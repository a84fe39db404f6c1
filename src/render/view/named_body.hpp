// A body of a scene by its name.
#pragma once

#include <string_view>

#include "tumble/scene_world.hpp"

namespace tumble::render {

// The body of that name that exists now; null if there is none.
inline const SceneInstance* find_body(const SceneWorld& world, std::string_view name) {
    if (name.empty()) return nullptr;
    for (const SceneInstance& body : world.bodies)
        if (body.name == name && world.world.is_valid(body.id)) return &body;
    return nullptr;
}

}  // namespace tumble::render
