// A body by its name, or all its copies by their common one, in a world where bodies come and go.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/names.hpp"
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

// A body, or the copies that share its name, in a world where they come and go.
class BodyGroup {
public:
    BodyGroup(std::string name, bool of_copies) : name_(std::move(name)), of_copies_(of_copies) {}

    // To be called before the questions below, for every state. Each instance is looked at once.
    void update(const SceneWorld& built) {
        std::erase_if(members_, [&](const SceneInstance& body) { return !built.world.is_valid(body.id); });
        for (; searched_ < built.bodies.size(); ++searched_) {
            const SceneInstance& body = built.bodies[searched_];
            if ((of_copies_ ? base_name(body.name) : body.name) != name_ || !built.world.is_valid(body.id)) continue;
            members_.push_back(body);
            ids_.insert(body.id);
        }
    }

    const std::string& name() const { return name_; }
    const std::vector<SceneInstance>& members() const { return members_; }  // that are there
    bool has(BodyId body) const { return ids_.contains(body); }

private:
    std::string name_;
    bool of_copies_;
    std::size_t searched_ = 0;
    std::vector<SceneInstance> members_;
    std::set<BodyId> ids_;
};

}  // namespace tumble::scene
