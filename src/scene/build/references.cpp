#include "scene/build/references.hpp"

#include "scene/json/json_text.hpp"

namespace tumble::scene {

std::optional<std::size_t> References::body(const std::string& name, const std::string& pointer,
                                            const std::string& key) const {
    const std::optional<std::size_t> found = names_.find(name);
    if (found || bodies_unread_) return found;
    if (name.empty())
        diagnostics_.error(pointer, "the key " + quoted(key) + " is missing: the name of a body");
    else
        diagnostics_.error(pointer + '/' + key, "there is no body " + quoted(name), names_.hint(name));
    return std::nullopt;
}

void References::any_body(const std::string& name, const std::string& pointer, const std::string& key) const {
    if (!names_.is_spawned(name)) body(name, pointer, key);
}

void References::body_or_copies(const std::string& name, const std::string& pointer, const std::string& key) const {
    if (!names_.is_shared(name)) any_body(name, pointer, key);
}

const SceneJoint* References::joint(const std::string& name, const std::string& pointer, const std::string& key,
                                    bool or_all) const {
    if (const std::optional<NamedPlace> place = joint_names_.find(name)) return &scene_.joints[place->source];
    if (const std::optional<std::size_t> all = joint_names_.find_source(name); or_all && all)
        return &scene_.joints[*all];
    if (diagnostics_.has_errors_in("/joints")) return nullptr;
    if (name.empty()) {
        diagnostics_.error(pointer, "the key " + quoted(key) + " is missing: the name of a joint");
        return nullptr;
    }
    diagnostics_.error(pointer + '/' + key, "there is no joint " + quoted(name), joint_names_.hint(name));
    return nullptr;
}

}  // namespace tumble::scene
