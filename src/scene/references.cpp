#include "scene/references.hpp"

#include <string_view>
#include <vector>

#include "scene/joint_copies.hpp"
#include "scene/json_text.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

std::optional<std::size_t> References::body(const std::string& name, const std::string& pointer, const std::string& key) const {
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

const SceneJoint* References::joint(const std::string& name, const std::string& pointer, const std::string& key, bool or_all) const {
    const std::string_view base = base_name(name);
    const std::optional<std::size_t> copy = copy_number(name);
    for (const SceneJoint& joint : scene_.joints) {
        if (!name.empty() && (or_all || !joint.repeat) && joint.name == name) return &joint;
        if (joint.repeat && joint.name == base && copy && *copy < static_cast<std::size_t>(copy_count(joint))) return &joint;
    }
    if (diagnostics_.has_errors_in("/joints")) return nullptr;
    if (name.empty()) {
        diagnostics_.error(pointer, "the key " + quoted(key) + " is missing: the name of a joint");
        return nullptr;
    }
    std::vector<std::string_view> known;
    for (const SceneJoint& joint : scene_.joints)
        if (!joint.name.empty()) known.push_back(joint.name);
    diagnostics_.error(pointer + '/' + key, "there is no joint " + quoted(name),
                       known.empty() ? "no joint has a \"name\"" : suggestion(name, known));
    return nullptr;
}

}  // namespace tumble::scene
