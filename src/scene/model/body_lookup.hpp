// A body by its name, or all its copies by their common one, in a world where bodies come and go.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/model/names.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

class BodyLookup {
public:
    explicit BodyLookup(std::string name = {}) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }

    // Null while there is none; what has gone may come again under its name. Each instance is passed once: new ones
    // come last.
    const SceneInstance* find(const SceneWorld& built) {
        for (; next_ < built.bodies.size(); ++next_) {
            const SceneInstance& body = built.bodies[next_];
            if (body.name == name_ && built.world.is_valid(body.id)) return &body;
        }
        return nullptr;
    }

private:
    std::string name_;
    std::size_t next_ = 0;  // the one that was found last, or where to go on
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
