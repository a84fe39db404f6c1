// A body by its name, in a world where bodies come and go.
#pragma once

#include <string>
#include <utility>

#include "tumble/scene_world.hpp"

namespace tumble::scene {

class BodyLookup {
public:
    explicit BodyLookup(std::string name = {}) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }

    // Null while there is none. Each instance is looked at once: names do not change, and new ones come last.
    const SceneInstance* find(const SceneWorld& built) {
        for (; !found_ && searched_ < built.bodies.size(); ++searched_) found_ = built.bodies[searched_].name == name_;
        if (!found_) return nullptr;
        const SceneInstance& body = built.bodies[searched_ - 1];
        return built.world.is_valid(body.id) ? &body : nullptr;
    }

private:
    std::string name_;
    std::size_t searched_ = 0;
    bool found_ = false;
};

}  // namespace tumble::scene
