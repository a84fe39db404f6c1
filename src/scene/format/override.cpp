// Each override walks down the JSON value, in step with a scene of defaults that fills in missing values.
#include "scene/format/override.hpp"

#include <charconv>
#include <optional>

#include "scene/format/writer.hpp"
#include "scene/json/input.hpp"
#include "scene/json/pointer.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

// The index of the element that a step of a pointer refers to, by its index or, for bodies and joints, by its name. "-"
// appends an element.
std::optional<std::size_t> find_element(Json& array, const std::string& step) {
    if (step == "-") {
        array.emplace_back();
        return array.size() - 1;
    }
    std::size_t index = 0;
    const char* end = step.data() + step.size();
    const std::from_chars_result parsed = std::from_chars(step.data(), end, index);
    if (parsed.ec == std::errc{} && parsed.ptr == end && index < array.size()) return index;
    for (index = 0; index < array.size(); ++index)
        if (array[index].is_object() && array[index].value("name", Json()) == step) return index;
    return std::nullopt;
}

std::string names_hint(const std::string& step, const Json& array) {
    std::vector<std::string_view> names;
    for (const Json& element : array)
        if (const auto name = element.find("name"); element.is_object() && name != element.end() && name->is_string())
            names.push_back(name->get_ref<const std::string&>());
    return suggestion(step, names);
}

std::string keys_hint(const std::string& step, const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    const std::vector<std::string_view> views(keys.begin(), keys.end());
    return suggestion(step, views);
}

// Walks to the value that the pointer refers to. Creates the last key if it is missing, and earlier ones that the
// defaults contain. Null, with an error in `diagnostics`, if a step leads nowhere; otherwise `resolved` is the pointer
// with indices in place of names.
Json* find_or_create(Json& scene, const std::string& pointer, Diagnostics& diagnostics, std::string& resolved) {
    static const Json all_defaults = write_scene(Scene{}, true);
    const Json* defaults = &all_defaults;
    Json* value = &scene;
    const std::vector<std::string> steps = split_pointer(pointer);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string& step = steps[i];
        const bool known = defaults != nullptr && defaults->is_object() && defaults->contains(step);
        defaults = known ? &defaults->at(step) : nullptr;
        const std::string here = "step " + std::to_string(i + 1) + ", '" + step + "',";
        if (value->is_array()) {
            const std::optional<std::size_t> index = find_element(*value, step);
            if (!index) {
                diagnostics.error(
                    pointer, here + " is neither an index nor a name in an array of " + std::to_string(value->size()),
                    names_hint(step, *value));
                return nullptr;
            }
            value = &(*value)[*index];
            resolved = append_key(resolved, std::to_string(*index));
        } else if (value->is_object()) {
            const bool last = i + 1 == steps.size();
            if (!value->contains(step) && !known && !last) {
                diagnostics.error(pointer, here + " does not exist", keys_hint(step, *value));
                return nullptr;
            }
            if (!value->contains(step)) (*value)[step] = known ? *defaults : Json();
            value = &(*value)[step];
            resolved = append_key(resolved, step);
        } else {
            diagnostics.error(pointer, here + " is below a value that is neither an object nor an array");
            return nullptr;
        }
    }
    return value;
}

// The text as JSON or, if it is not JSON, as a string, so that names need no quotes.
Json parse_value(const std::string& text) {
    Diagnostics unused("", text);
    std::optional<Json> value = parse_json(text, unused);
    return value && !unused.has_errors() ? std::move(*value) : Json(text);
}

void apply_override(const std::string& text, Json& scene, Diagnostics& diagnostics) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || text[0] != '/') {
        diagnostics.add_origin(text, "--set " + text);
        diagnostics.error(text, "must read /json/pointer=value", "for example /world/gravity/1=-1.6");
        return;
    }
    const std::string pointer = text.substr(0, equals);
    std::string resolved;
    Json* const target = find_or_create(scene, pointer, diagnostics, resolved);
    if (target) *target = parse_value(text.substr(equals + 1));
    diagnostics.add_origin(target ? resolved : pointer, "--set " + text);
}

}  // namespace

void apply_overrides(const LoadOptions& options, Json& scene, Diagnostics& diagnostics) {
    for (const std::string& text : options.overrides) apply_override(text, scene, diagnostics);
    if (!options.seed) return;
    diagnostics.add_origin("/world/seed", "--seed " + std::to_string(*options.seed));
    std::string resolved;
    if (Json* seed = find_or_create(scene, "/world/seed", diagnostics, resolved)) *seed = *options.seed;
}

}  // namespace tumble::scene
