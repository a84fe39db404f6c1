#include "scene/format/foreign_words.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/json/json_text.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

// The hint for `key` in objects of this format that have the key `beside`.
struct ForeignKey {
    std::string_view key, beside, hint;
};
constexpr ForeignKey kKeys[] = {
    {"bodyA", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"bodyB", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"body_a", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"body_b", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"x", "position", R"("position": [x, y])"},
    {"y", "position", R"("position": [x, y])"},
    {"rotation", "position", R"("angle", in degrees, counter-clockwise)"},
    {"type", "circle", R"(the kind of a shape is its key: {"circle": {"radius": 1}})"},
    {"radius", "circle", R"({"circle": {"radius": 1}})"},
    {"size", "box", R"({"box": {"size": [2, 1]}})"},
    {"vertices", "polygon", R"({"polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]}})"},
    {"width", "size", R"("size": [width, height])"},
    {"height", "size", R"("size": [width, height])"},
    {"static", "shapes", R"("type": "static")"},
    {"kinematic", "shapes", R"("type": "kinematic")"},
    {"dynamic", "shapes", R"("type": "dynamic", the default)"},
    {"stiffness", "hertz", R"("hertz", the frequency of the spring: 1 is soft, 10 is stiff)"},
    {"damping", "hertz", R"("damping_ratio": 0 oscillates on, 1 does not overshoot)"},
    {"stiffness", "spring", R"("spring": {"hertz": 4, "damping_ratio": 0.5})"},
    {"damping", "spring", R"("spring": {"hertz": 4, "damping_ratio": 0.5})"},
    {"x", "touches", R"("inside": [[left, bottom], [right, top]])"},
    {"y", "touches", R"("height": [lower, upper])"},
    {"position", "touches", R"("inside": [[left, bottom], [right, top]])"},
    {"velocity", "touches", R"("speed": [lower, upper])"},
    {"time", "touches", R"("at": seconds)"},
    {"time", "despawn", R"("at": seconds)"},
    {"if", "despawn", R"~("when": "touching(a, b)")~"},
    {"on", "despawn", R"~("when": "touching(a, b)")~"},
    {"trigger", "despawn", R"~("when": "touching(a, b)")~"},
    {"condition", "despawn", R"~("when": "touching(a, b)")~"},
    {"end", "despawn", R"("stop": true)"},
    {"claims", "expect", R"(claims are listed under "expect")"},
    {"assertions", "expect", R"(claims are listed under "expect")"},
    {"tests", "expect", R"(claims are listed under "expect")"},
    {"events", "timeline", R"(events are listed under "timeline")"},
    {"dt", "steps_per_second", R"("steps_per_second": 60)"},
    {"time_step", "steps_per_second", R"("steps_per_second": 60)"},
    {"revolute", "bodies", R"("type": "revolute")"},
    {"prismatic", "bodies", R"("type": "prismatic")"},
    {"distance", "bodies", R"("type": "distance")"},
    {"weld", "bodies", R"("type": "weld")"},
};

// Objects that are often written as a number or an array: the key, and what is around a number in this format.
struct PlainValue {
    std::string_view key, before, after;
};
constexpr PlainValue kPlainValues[] = {
    {"mass", R"("mass": {"mass": )", "}"},
    {"repeat", R"(of a body: "repeat": {"grid": {"columns": 5}}; of a joint: "repeat": {"columns": 5})", ""},
    {"spring", R"("spring": {"hertz": )", "}"},
    {"angular_spring", R"("angular_spring": {"hertz": )", "}"},
    {"motor", R"("motor": {"speed": )", R"(, "max_torque": 10}, or "max_force" if it slides)"},
    {"circle", R"("circle": {"radius": )", "}"},
    {"box", R"("box": {"size": [width, height]})", ""},
    {"polygon", R"("polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]})", ""},
};

constexpr std::pair<std::string_view, std::string_view> kColors[] = {
    {"black", "#000"}, {"white", "#fff"}, {"gray", "#888"},   {"grey", "#888"},    {"red", "#f00"},
    {"green", "#080"}, {"blue", "#00f"},  {"yellow", "#ff0"}, {"orange", "#fa0"},  {"purple", "#808"},
    {"pink", "#fbc"},  {"brown", "#a52"}, {"cyan", "#0ff"},   {"magenta", "#f0f"},
};

// Types of joints: the foreign word, and that of this format.
constexpr std::pair<std::string_view, std::string_view> kJointTypes[] = {
    {"hinge", "revolute"}, {"pin", "revolute"},    {"slider", "prismatic"}, {"rope", "distance"},
    {"rod", "distance"},   {"spring", "distance"}, {"fixed", "weld"},
};

bool contains(std::span<const std::string_view> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::string_view hint_for_foreign_key(std::string_view key, std::span<const std::string_view> known) {
    for (const ForeignKey& foreign : kKeys)
        if (foreign.key == key && contains(known, foreign.beside)) return foreign.hint;
    return {};
}

std::string hint_for_plain_value(std::string_view key, const Json& value) {
    if (!value.is_number() && !value.is_array()) return {};
    for (const PlainValue& plain : kPlainValues) {
        const bool holds_number = plain.before.ends_with(": ");
        if (plain.key == key && (value.is_number() || !holds_number))
            return std::string(plain.before) + (holds_number ? compact_text(value) : "") + std::string(plain.after);
    }
    return {};
}

std::string hint_for_color(std::string_view name) {
    const auto found = std::ranges::find(kColors, name, &std::pair<std::string_view, std::string_view>::first);
    return found == std::end(kColors) ? R"(for example "#d33")"
                                      : std::string(name) + " is \"" + std::string(found->second) + "\"";
}

std::string hint_for_foreign_word(std::string_view word, std::span<const std::string_view> names) {
    for (const auto& [foreign, own] : kJointTypes)
        if (word == foreign && contains(names, own)) return "this format calls it '" + std::string(own) + "'";
    return nearest_word(word, names).empty() ? "" : suggestion(word, names);
}

}  // namespace tumble::scene
