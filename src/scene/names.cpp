// Names of copies are not stored: a name is taken apart, which stays cheap for a million copies.
#include "scene/names.hpp"

#include <charconv>

#include "scene/joint_copies.hpp"
#include "scene/repeat.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

BodyNames::BodyNames(const Scene& scene) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        const std::size_t count = static_cast<std::size_t>(copy_count(body));
        if (!body.name.empty()) sources_.emplace(body.name, Source{i, first, count, body.repeat.has_value()});
        first += count;
    }
    for (const SceneEvent& event : scene.timeline)
        if (event.spawn && !event.spawn->name.empty()) spawned_.emplace(event.spawn->name, event.every || event.spawn->repeat);
}

bool BodyNames::is_spawned(std::string_view name) const {
    const std::string_view base = base_name(name);
    const auto found = spawned_.find(base);
    return found != spawned_.end() && found->second == (base != name);
}

bool BodyNames::is_shared(std::string_view name) const {
    const auto source = sources_.find(name);
    const auto spawned = spawned_.find(name);
    return (source != sources_.end() && source->second.repeated) || (spawned != spawned_.end() && spawned->second);
}

std::optional<std::size_t> BodyNames::find(std::string_view name) const {
    const auto exact = sources_.find(name);
    if (exact != sources_.end() && !exact->second.repeated) return exact->second.first;
    return find_copy(name);
}

std::optional<std::size_t> BodyNames::find_copy(std::string_view name) const {
    const std::optional<std::size_t> copy = copy_number(name);
    const auto repeated = sources_.find(base_name(name));
    if (!copy || repeated == sources_.end() || !repeated->second.repeated || *copy >= repeated->second.count) return std::nullopt;
    return repeated->second.first + *copy;
}

std::optional<std::size_t> BodyNames::copies_after(std::string_view name) const {
    const std::optional<std::size_t> copy = find_copy(name);
    if (!copy) return std::nullopt;
    const Source& source = sources_.find(base_name(name))->second;
    return source.first + source.count - 1 - *copy;
}

std::optional<std::size_t> BodyNames::find_source(std::string_view name) const {
    const auto found = sources_.find(name);
    if (found == sources_.end()) return std::nullopt;
    return found->second.index;
}

std::string BodyNames::hint(std::string_view name) const {
    const auto found = sources_.find(name.substr(0, name.rfind('[')));
    if (found != sources_.end() && found->second.repeated) {
        const std::string& base = found->first;
        return "the copies are called " + base + "[0] to " + base + "[" + std::to_string(found->second.count - 1) + "]";
    }
    std::vector<std::string_view> names;
    for (const auto& [known, source] : sources_) names.push_back(known);
    for (const auto& [known, again] : spawned_) names.push_back(known);
    return suggestion(name, names);
}

const SceneBody* find_definition(const Scene& scene, const BodyNames& names, std::string_view name) {
    const std::optional<std::size_t> exact = names.find_source(name), shared = names.find_source(base_name(name));
    if (exact) return &scene.bodies[*exact];
    if (shared && names.is_copy(name)) return &scene.bodies[*shared];
    for (const SceneEvent& event : scene.timeline)
        if (event.spawn && (event.spawn->name == name || event.spawn->name == base_name(name))) return &*event.spawn;
    return nullptr;
}

JointNames::JointNames(const Scene& scene) {
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const SceneJoint& joint = scene.joints[i];
        const auto count = static_cast<std::size_t>(copy_count(joint));
        if (!joint.name.empty()) sources_.emplace(joint.name, JointPlace{i, 0, count, joint.repeat.has_value()});
    }
}

std::optional<JointPlace> JointNames::find(std::string_view name) const {
    const auto exact = sources_.find(name);
    if (exact != sources_.end() && !exact->second.is_copy) return exact->second;
    const std::optional<std::size_t> copy = copy_number(name);
    const auto repeated = sources_.find(base_name(name));
    if (!copy || repeated == sources_.end() || !repeated->second.is_copy || *copy >= repeated->second.count) return std::nullopt;
    JointPlace place = repeated->second;
    place.copy = *copy;
    return place;
}

std::optional<std::size_t> JointNames::find_source(std::string_view name) const {
    const auto found = sources_.find(name);
    if (found == sources_.end()) return std::nullopt;
    return found->second.source;
}

std::string copy_name(const SceneBody& body, std::size_t copy) {
    return body.repeat ? copy_name(body.name, copy) : body.name;
}

std::string copy_name(const SceneJoint& joint, std::size_t copy) {
    return joint.repeat ? copy_name(joint.name, copy) : joint.name;
}

std::string copy_name(const std::string& name, std::size_t copy) {
    return name.empty() ? name : name + '[' + std::to_string(copy) + ']';
}

std::optional<std::size_t> copy_number(std::string_view name) {
    const std::string_view base = base_name(name);
    if (base == name) return std::nullopt;
    const std::string_view digits = name.substr(base.size() + 1, name.size() - base.size() - 2);
    std::size_t copy = 0;
    const std::from_chars_result parsed = std::from_chars(digits.data(), digits.data() + digits.size(), copy);
    return parsed.ec == std::errc{} && std::to_string(copy) == digits ? std::optional(copy) : std::nullopt;
}

std::string_view base_name(std::string_view name) {
    const std::size_t bracket = name.rfind('[');
    return bracket == std::string_view::npos || name.back() != ']' ? name : name.substr(0, bracket);
}

}  // namespace tumble::scene
