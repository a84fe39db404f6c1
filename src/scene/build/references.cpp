#include "scene/build/references.hpp"

#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

// The hint for a body that does not exist. A joint to the world is a joint to a body that never moves.
std::string hint_for_body(const BodyNames& names, const std::string& name, const std::string& pointer) {
    std::string hint = names.hint(name);
    const bool means_world = name == "world" || name == "ground" || name == "background";
    if (!means_world || !pointer.starts_with("/joints") || hint.starts_with("did you mean")) return hint;
    return "a joint needs two bodies; one that never moves is {\"name\": " + quoted(name) + R"(, "type": "static"})";
}

}  // namespace

std::optional<std::size_t> References::body(const std::string& name, const std::string& pointer,
                                            const std::string& key) const {
    const BodyNames& names = resolved_.body_names;
    const std::optional<std::size_t> found = names.find(name);
    if (found || resolved_.bodies_unread) return found;
    if (name.empty())
        diagnostics_.error(pointer, "the key " + quoted(key) + " is missing: the name of a body");
    else
        diagnostics_.error(pointer + '/' + key, "there is no body " + quoted(name),
                           hint_for_body(names, name, pointer));
    return std::nullopt;
}

void References::any_body(const std::string& name, const std::string& pointer, const std::string& key) const {
    if (!resolved_.body_names.is_spawned(name)) body(name, pointer, key);
}

void References::body_or_copies(const std::string& name, const std::string& pointer, const std::string& key) const {
    if (!resolved_.body_names.is_shared(name)) any_body(name, pointer, key);
}

const SceneJoint* References::joint(const std::string& name, const std::string& pointer, const std::string& key,
                                    bool or_all) const {
    const JointNames& names = resolved_.joint_names;
    if (const std::optional<NamedCopy> copy = names.find(name)) return &scene_.joints[copy->source];
    if (const std::optional<std::size_t> all = names.find_source(name); or_all && all) return &scene_.joints[*all];
    if (diagnostics_.has_errors_in("/joints")) return nullptr;
    if (name.empty()) {
        diagnostics_.error(pointer, "the key " + quoted(key) + " is missing: the name of a joint");
        return nullptr;
    }
    diagnostics_.error(pointer + '/' + key, "there is no joint " + quoted(name), names.hint(name));
    return nullptr;
}

std::optional<KnownNames> References::known_names() const {
    if (resolved_.bodies_unread || diagnostics_.has_errors_in("/joints") || diagnostics_.has_errors_in("/timeline"))
        return std::nullopt;
    return KnownNames{scene_, resolved_.body_names, resolved_.joint_names};
}

}  // namespace tumble::scene
