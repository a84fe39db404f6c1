// Overrides: a walk down the JSON value for each, with the defaults beside it.
#include "scene/override.hpp"

#include <algorithm>
#include <charconv>

#include "scene/input.hpp"
#include "scene/pointer.hpp"
#include "scene/suggest.hpp"
#include "scene/writer.hpp"

namespace tumble::scene {

namespace {

// The element that a step of a pointer names, or null. "-" is the one after the last.
Json* find_element(Json& array, const std::string& step) {
    if (step == "-") return &array.emplace_back();
    std::size_t index = 0;
    const char* end = step.data() + step.size();
    const std::from_chars_result parsed = std::from_chars(step.data(), end, index);
    if (parsed.ec != std::errc{} || parsed.ptr != end || index >= array.size()) return nullptr;
    return &array[index];
}

std::string keys_hint(const std::string& step, const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    const std::vector<std::string_view> views(keys.begin(), keys.end());
    return suggestion(step, views);
}

// Walks to the value that the pointer names, creating the last key and what `defaults` knows. Null, with an error in
// `diagnostics`, if the way ends.
Json* find_or_create(Json& scene, const std::string& pointer, Diagnostics& diagnostics) {
    const Json all_defaults = write_scene(Scene{}, true);
    const Json* defaults = &all_defaults;
    Json* value = &scene;
    const std::vector<std::string> steps = split_pointer(pointer);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string& step = steps[i];
        const bool known = defaults != nullptr && defaults->is_object() && defaults->contains(step);
        defaults = known ? &defaults->at(step) : nullptr;
        const std::string here = std::to_string(i + 1) + ". step '" + step + "'";
        if (value->is_array()) {
            const std::size_t size = value->size();
            value = find_element(*value, step);
            if (value == nullptr) {
                diagnostics.error(pointer, "the " + here + " is no index of an array of " + std::to_string(size));
                return nullptr;
            }
        } else if (value->is_object()) {
            const bool last = i + 1 == steps.size();
            if (!value->contains(step) && !known && !last) {
                diagnostics.error(pointer, "the " + here + " does not exist", keys_hint(step, *value));
                return nullptr;
            }
            if (!value->contains(step)) (*value)[step] = known ? *defaults : Json();
            value = &(*value)[step];
        } else {
            diagnostics.error(pointer, "the " + here + " lies below a value that is no object and no array");
            return nullptr;
        }
    }
    return value;
}

// JSON, or else the text itself, so that names need no quotes.
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
    diagnostics.add_origin(pointer, "--set " + text);
    if (Json* target = find_or_create(scene, pointer, diagnostics)) *target = parse_value(text.substr(equals + 1));
}

}  // namespace

void apply_overrides(const LoadOptions& options, Json& scene, Diagnostics& diagnostics) {
    for (const std::string& text : options.overrides) apply_override(text, scene, diagnostics);
    if (!options.seed) return;
    diagnostics.add_origin("/world/seed", "--seed " + std::to_string(*options.seed));
    if (Json* seed = find_or_create(scene, "/world/seed", diagnostics)) *seed = *options.seed;
}

}  // namespace tumble::scene
