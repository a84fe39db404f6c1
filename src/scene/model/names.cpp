// Names of copies are not stored: "crate[3]" is split into base and number, which stays cheap for a million copies.
#include "scene/model/names.hpp"

#include <algorithm>
#include <charconv>

#include "scene/model/repeat.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

// A suggestion for an unknown name. `copies_of` returns the text for the copies that share a known name.
template <class CopiesOf>
std::string hint_for(std::string_view name, const std::vector<std::string_view>& known, const CopiesOf& copies_of) {
    const std::string_view base = name.substr(0, name.rfind('['));
    const bool is_base = std::ranges::find(known, base) != known.end();
    const std::string_view meant = is_base ? base : nearest_word(base, known);
    const std::string copies = copies_of(meant);
    if (copies.empty()) return suggestion(name, known);
    return (is_base ? "" : "did you mean '" + std::string(meant) + "'? ") + "the copies are called " + copies;
}

}  // namespace

void EntryNames::add(const std::string& name, const NamedCopy& first) {
    if (!name.empty()) first_.emplace(name, first);
}

std::optional<NamedCopy> EntryNames::find(std::string_view name) const {
    const auto exact = first_.find(name);
    if (exact != first_.end() && !exact->second.is_copy) return exact->second;
    return find_copy(name);
}

std::optional<NamedCopy> EntryNames::find_copy(std::string_view name) const {
    const std::optional<std::size_t> copy = copy_number(name);
    const auto repeated = first_.find(base_name(name));
    if (!copy || repeated == first_.end() || !repeated->second.is_copy || *copy >= repeated->second.count)
        return std::nullopt;
    NamedCopy result = repeated->second;
    result.copy = *copy;
    return result;
}

std::optional<std::size_t> EntryNames::find_source(std::string_view name) const {
    const auto found = first_.find(name);
    if (found == first_.end()) return std::nullopt;
    return found->second.source;
}

bool EntryNames::is_shared(std::string_view name) const {
    const auto found = first_.find(name);
    return found != first_.end() && found->second.is_copy;
}

std::string EntryNames::copies_text(std::string_view name) const {
    if (!is_shared(name)) return "";
    const auto& [base, first] = *first_.find(name);
    return copy_name(base, 0) + " to " + copy_name(base, first.count - 1);
}

void EntryNames::append_to(std::vector<std::string_view>& names) const {
    for (const auto& [name, first] : first_) names.push_back(name);
}

BodyNames::BodyNames(const Scene& scene) {
    std::size_t built = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        const auto count = static_cast<std::size_t>(copy_count(body));
        entries_.add(body.name, {i, 0, count, body.repeat.has_value()});
        first_built_.push_back(built);
        built += count;
    }
    built_count_ = built;
    for (std::size_t i = 0; i < scene.timeline.size(); ++i) {
        const SceneEvent& event = scene.timeline[i];
        if (event.spawn && !event.spawn->name.empty())
            spawned_.emplace(event.spawn->name, Spawned{i, event.every || event.spawn->repeat});
    }
}

bool BodyNames::is_spawned(std::string_view name) const {
    const auto exact = spawned_.find(name), again = spawned_.find(base_name(name));
    return (exact != spawned_.end() && !exact->second.repeats) ||
           (again != spawned_.end() && again->second.repeats && again != exact);
}

std::optional<std::size_t> BodyNames::find_event(std::string_view name) const {
    auto found = spawned_.find(name);
    if (found == spawned_.end()) found = spawned_.find(base_name(name));
    if (found == spawned_.end()) return std::nullopt;
    return found->second.event;
}

bool BodyNames::is_shared(std::string_view name) const {
    const auto spawned = spawned_.find(name);
    return entries_.is_shared(name) || (spawned != spawned_.end() && spawned->second.repeats);
}

std::optional<std::size_t> BodyNames::find(std::string_view name) const {
    const std::optional<NamedCopy> found = entries_.find(name);
    if (!found) return std::nullopt;
    return first_built_[found->source] + found->copy;
}

std::optional<std::size_t> BodyNames::copies_after(std::string_view name) const {
    const std::optional<NamedCopy> found = entries_.find_copy(name);
    if (!found) return std::nullopt;
    return found->count - 1 - found->copy;
}

std::string BodyNames::hint(std::string_view name) const {
    if (is_spawned(name)) return "the timeline spawns it: it does not exist at the start";
    std::vector<std::string_view> known;
    entries_.append_to(known);
    for (const auto& [spawned, event] : spawned_) known.push_back(spawned);
    return hint_for(name, known, [this](std::string_view meant) {
        const auto spawned = spawned_.find(meant);
        const bool repeats = spawned != spawned_.end() && spawned->second.repeats;
        return repeats ? copy_name(spawned->first, 0) + ", " + copy_name(spawned->first, 1) + " and so on"
                       : entries_.copies_text(meant);
    });
}

const SceneBody* find_definition(const Scene& scene, const BodyNames& names, std::string_view name) {
    const std::optional<std::size_t> exact = names.find_source(name), shared = names.find_source(base_name(name));
    if (exact) return &scene.bodies[*exact];
    if (shared && names.is_copy(name)) return &scene.bodies[*shared];
    const std::optional<std::size_t> event = names.find_event(name);
    return event ? &*scene.timeline[*event].spawn : nullptr;
}

JointNames::JointNames(const Scene& scene) {
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const SceneJoint& joint = scene.joints[i];
        entries_.add(joint.name, {i, 0, static_cast<std::size_t>(copy_count(joint)), joint.repeat.has_value()});
    }
    first_built_.resize(scene.joints.size());
    std::size_t built = 0;
    for (const bool is_gear : {false, true}) {
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            if ((scene.joints[i].type == SceneJointType::gear) != is_gear) continue;
            first_built_[i] = built;
            built += static_cast<std::size_t>(copy_count(scene.joints[i]));
        }
    }
}

std::string JointNames::hint(std::string_view name) const {
    std::vector<std::string_view> known;
    entries_.append_to(known);
    if (known.empty()) return "no joint has a \"name\"";
    return hint_for(name, known, [this](std::string_view meant) { return entries_.copies_text(meant); });
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
