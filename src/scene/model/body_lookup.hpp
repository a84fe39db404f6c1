// Finds a body, or all copies of one, by name in a world in which bodies are spawned and despawned.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "debug/check.hpp"
#include "scene/model/names.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// One body.
class BodyLookup {
public:
    // The search starts at the instance `first`: none before it has the name.
    explicit BodyLookup(std::string name = {}, std::size_t first = 0) : name_(std::move(name)), next_(first) {}

    const std::string& name() const { return name_; }

    // Null while no body has the name, and if the name is empty; a later body may have the name of one that was
    // despawned. The search goes on where the last one ended, as new instances are appended.
    const SceneInstance* find(const SceneWorld& built) {
        if (name_.empty()) return nullptr;
        TUMBLE_CHECK(next_ <= built.bodies.size());
        for (; next_ < built.bodies.size(); ++next_) {
            const SceneInstance& body = built.bodies[next_];
            if (body.name == name_ && built.world.is_valid(body.id)) return &body;
        }
        return nullptr;
    }

private:
    std::string name_;
    std::size_t next_;  // the instance that was found last, or the first one that was not searched
};

// A body, or all copies that share a name.
class BodyGroup {
public:
    BodyGroup(std::string name, bool of_copies) : name_(std::move(name)), of_copies_(of_copies) {}

    // To be called for every state, before the accessors below. Searches each instance once.
    void update(const SceneWorld& built) {
        std::erase_if(members_, [&](const SceneInstance& body) { return !built.world.is_valid(body.id); });
        TUMBLE_CHECK(searched_ <= built.bodies.size());
        for (; searched_ < built.bodies.size(); ++searched_) {
            const SceneInstance& body = built.bodies[searched_];
            if ((of_copies_ ? base_name(body.name) : body.name) != name_ || !built.world.is_valid(body.id)) continue;
            members_.push_back(body);
            ids_.insert(body.id);
        }
    }

    const std::string& name() const { return name_; }
    const std::vector<SceneInstance>& members() const { return members_; }  // those that exist
    bool has(BodyId body) const { return ids_.contains(body); }

private:
    std::string name_;
    bool of_copies_;
    std::size_t searched_ = 0;
    std::vector<SceneInstance> members_;
    std::set<BodyId> ids_;
};

}  // namespace tumble::scene
