#include "scene/format/foreign_words.hpp"

#include <algorithm>
#include <cstdint>
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
    {"circle", "shapes", R"("shapes": [{"circle": {"radius": 1}}])"},
    {"box", "shapes", R"("shapes": [{"box": {"size": [2, 1]}}])"},
    {"polygon", "shapes", R"("shapes": [{"polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]}}])"},
    {"rect", "circle", R"({"box": {"size": [2, 1]}})"},
    {"rectangle", "circle", R"({"box": {"size": [2, 1]}})"},
    {"square", "circle", R"({"box": {"size": [1, 1]}})"},
    {"triangle", "circle", R"({"polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]}})"},
    {"line", "circle", R"({"segment": {"from": [0, 0], "to": [1, 0]}})"},
    {"edge", "circle", R"({"segment": {"from": [0, 0], "to": [1, 0]}})"},
    {"type", "circle", R"(the kind of a shape is its key: {"circle": {"radius": 1}})"},
    {"radius", "circle", R"({"circle": {"radius": 1}})"},
    {"size", "box", R"({"box": {"size": [2, 1]}})"},
    {"vertices", "polygon", R"({"polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]}})"},
    {"diameter", "radius", R"("radius", half of the diameter)"},
    {"points", "vertices", R"("vertices": [[0, 0], [1, 0], [0, 1]])"},
    {"vertices", "points", R"("points": [[0, 0], [1, 0], [0, 1]])"},
    {"count", "grid", R"("grid": {"columns": 5})"},
    {"columns", "grid", R"("grid": {"columns": 5})"},
    {"rows", "grid", R"("grid": {"rows": 5})"},
    {"bounce", "restitution", R"("restitution", 0 to 1)"},
    {"bounciness", "restitution", R"("restitution", 0 to 1)"},
    {"elasticity", "restitution", R"("restitution", 0 to 1)"},
    {"zoom", "follow", R"("height", in m, of the part of the world that the frame shows)"},
    {"width", "follow", R"("height", in m; the width follows from the frame)"},
    {"position", "follow", R"("center": [x, y])"},
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
    {"t", "despawn", R"("at": seconds)"},
    {"action", "despawn", R"(the action is a key: "impulse": [1, 0])"},
    {"remove", "despawn", R"("despawn": "name of a body")"},
    {"delete", "despawn", R"("despawn": "name of a body")"},
    {"destroy", "despawn", R"("despawn": "name of a body")"},
    {"create", "despawn", R"("spawn": {"name": "drop", "shapes": [{"circle": {"radius": 0.2}}]})"},
    {"if", "despawn", R"~("when": "touching(a, b)")~"},
    {"on", "despawn", R"~("when": "touching(a, b)")~"},
    {"trigger", "despawn", R"~("when": "touching(a, b)")~"},
    {"condition", "despawn", R"~("when": "touching(a, b)")~"},
    {"end", "despawn", R"("stop": true)"},
    {"then", "despawn", R"~(the action stands beside: {"when": "touching(a, b)", "stop": true})~"},
    {"do", "despawn", R"~(the action stands beside: {"when": "touching(a, b)", "stop": true})~"},
    {"motor_speed", "break_force", R"("motor": {"speed": 90, "max_torque": 10}, or "max_force" if it slides)"},
    {"claims", "expect", R"(claims are listed under "expect")"},
    {"assertions", "expect", R"(claims are listed under "expect")"},
    {"tests", "expect", R"(claims are listed under "expect")"},
    {"events", "timeline", R"(events are listed under "timeline")"},
    {"scene", "timeline", "this is a plan, which `tumble sweep` runs"},
    {"scenes", "timeline", "this is a plan, which `tumble sweep` runs"},
    {"body", "timeline", R"("bodies"; `tumble import` reads an export of R.U.B.E.)"},
    {"objects", "bodies", R"(bodies are listed under "bodies")"},
    {"constraints", "joints", R"(joints are listed under "joints")"},
    {"time", "steps_per_second", R"("duration": seconds)"},
    {"fps", "steps_per_second", R"("steps_per_second"; that of the frames is the option --fps of `tumble run`)"},
    {"dt", "steps_per_second", R"("steps_per_second": 60)"},
    {"time_step", "steps_per_second", R"("steps_per_second": 60)"},
    {"target", "break_force",
     R"(of a mouse joint, "anchor" is the first target; an event moves it: )"
     R"({"at": 1, "joint": "j", "target": [0, 1]})"},
    {"uniform", "log_range", R"("range": [lower, upper] without "count" is drawn)"},
    {"values", "log_range", R"("list": [1, 2, 3])"},
    {"step", "log_range", R"("count", how many values the range has)"},
    {"steps", "log_range", R"("count", how many values the range has)"},
    {"revolute", "bodies", R"("type": "revolute")"},
    {"prismatic", "bodies", R"("type": "prismatic")"},
    {"distance", "bodies", R"("type": "distance")"},
    {"weld", "bodies", R"("type": "weld")"},
};

// Objects that are often written in a simpler form: the key, and what is around a number in this format.
struct PlainValue {
    std::string_view key, before, after;
};
constexpr PlainValue kPlainValues[] = {
    {"mass", R"("mass": {"mass": )", R"(, "inertia": 1}, or a "density" of the material)"},
    {"repeat", R"(of a body: "repeat": {"grid": {"columns": 5}}; of a joint: "repeat": {"columns": 5})", ""},
    {"spring", R"("spring": {"hertz": )", "}"},
    {"angular_spring", R"("angular_spring": {"hertz": )", "}"},
    {"motor", R"("motor": {"speed": )", R"(, "max_torque": 10}, or "max_force" if it slides)"},
    {"circle", R"("circle": {"radius": )", "}"},
    {"box", R"("box": {"size": [width, height]})", ""},
    {"polygon", R"("polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]})", ""},
    {"filter", R"(of a shape: "filter": {"group": -1}; of a plan: "filter": {"that": "ball.x > 1"})", ""},
    {"grid", R"("grid": {"columns": 3, "rows": 2})", ""},
    {"include", R"({"file": "part.json"})", ""},
    {"expect", R"({"that": "ball.x > 1"})", ""},
    {"frame", R"("frame": {"position": [0, 0], "angle": 30}; the claim about a picture is "picture": "golden.png")",
     ""},
};

// Values of other kinds.
struct WrongValue {
    std::string_view key, hint;
};
constexpr WrongValue kWrongValues[] = {
    {"state_hash", R"(16 digits in quotes: "0000000000000000", which `tumble check --update` replaces)"},
    {"when", R"~(an expression in quotes: "touching(a, b)")~"},
    {"that", R"(an expression in quotes: "ball.x > 1")"},
};

constexpr std::pair<std::string_view, std::string_view> kColors[] = {
    {"black", "#000"}, {"white", "#fff"}, {"gray", "#888"},   {"grey", "#888"},    {"red", "#f00"},
    {"green", "#080"}, {"blue", "#00f"},  {"yellow", "#ff0"}, {"orange", "#fa0"},  {"purple", "#808"},
    {"pink", "#fbc"},  {"brown", "#a52"}, {"cyan", "#0ff"},   {"magenta", "#f0f"},
};

// Types of joints and of bodies: the foreign word, that of this format, and what the object needs too.
struct ForeignWord {
    std::string_view foreign, own, with;
};
constexpr ForeignWord kWords[] = {
    {"hinge", "revolute", ""},
    {"pin", "revolute", ""},
    {"slider", "prismatic", ""},
    {"rod", "distance", ""},
    {"rope", "distance", R"(, with "limits": [0, length])"},
    {"spring", "distance", R"(, with "spring": {"hertz": 4})"},
    {"fixed", "weld", ""},
    {"fixed", "static", ""},
    {"immovable", "static", ""},
    {"movable", "dynamic", ""},
    {"rigid", "dynamic", ""},
};

bool contains(std::span<const std::string_view> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

// For an object that was given as something else.
std::string hint_for_plain_value(std::string_view key, const Json& value) {
    for (const PlainValue& plain : kPlainValues) {
        if (plain.key != key) continue;
        const bool holds_number = plain.before.ends_with(": ");
        const std::string number = value.is_number() ? compact_text(value) : "1";
        return std::string(plain.before) + (holds_number ? number : "") + std::string(plain.after);
    }
    return {};
}

// For a text in place of a number: "3m" is 3.
std::string hint_for_text_number(const std::string& text) {
    const std::size_t begin = text.find_first_not_of("+-.");
    const bool is_number = begin != std::string::npos && text[begin] >= '0' && text[begin] <= '9';
    return is_number ? "a number without quotes and without a unit" : "";
}

// For a vector or a range that is written as an object.
std::string hint_for_pair(const Json& value) {
    for (const std::string_view kind : {"uniform", "normal"})
        if (value.contains(kind)) {
            const std::string draw = "{\"" + std::string(kind) + "\": [0, 1]}";
            return "each number is drawn by itself: [" + draw + ", " + draw + "]";
        }
    for (const auto& [first, second] : {std::pair{"x", "y"}, {"lower", "upper"}, {"min", "max"}})
        if (value.contains(first) && value.contains(second))
            return "[" + compact_text(value[first]) + ", " + compact_text(value[second]) + "]";
    return {};
}

// For a colour that is given by three numbers from 0 to 255.
std::string hint_for_color_levels(const Json& value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string color = "\"#";
    for (const Json& level : value) {
        if (!level.is_number_unsigned() || level.get<std::uint64_t>() > 255) return R"(for example "#d33")";
        const auto number = level.get<std::size_t>();
        color += {kDigits[number / 16], kDigits[number % 16]};
    }
    return value.size() == 3 ? color + '"' : R"(for example "#d33")";
}

}  // namespace

std::string_view hint_for_foreign_key(std::string_view key, std::span<const std::string_view> known) {
    for (const ForeignKey& foreign : kKeys)
        if (foreign.key == key && contains(known, foreign.beside)) return foreign.hint;
    return {};
}

std::string hint_for_wrong_value(std::string_view key, std::string_view wanted, const Json& value) {
    for (const WrongValue& wrong : kWrongValues)
        if (wrong.key == key && wanted == "a string") return std::string(wrong.hint);
    if (key == "color" && value.is_array()) return hint_for_color_levels(value);
    if (wanted == "an object") return hint_for_plain_value(key, value);
    if (wanted == "an array" && value.is_object()) return "in brackets, as a list: [{...}]";
    if (wanted == "true or false" && (value == "true" || value == "false")) return "without quotes";
    if (wanted.ends_with(" number") && value.is_string()) return hint_for_text_number(value.get<std::string>());
    if (value.is_object() && wanted.ends_with(']')) return hint_for_pair(value);
    if (value.is_number() && wanted == "[lower, upper]") {
        const std::string number = compact_text(value);
        return "[" + number + ", " + number + "] for exactly " + number;
    }
    if (value.is_number() && wanted == "a vector [x, y]")
        return "a number for x and one for y: [0, " + compact_text(value) + "]";
    if (wanted == "an array of 2" && value.is_array() && value.size() == 4) return "two corners: [[0, 0], [1, 1]]";
    return {};
}

std::string hint_for_color(std::string_view name) {
    const auto found = std::ranges::find(kColors, name, &std::pair<std::string_view, std::string_view>::first);
    return found == std::end(kColors) ? R"(for example "#d33")"
                                      : std::string(name) + " is \"" + std::string(found->second) + "\"";
}

std::string hint_for_foreign_word(std::string_view word, std::span<const std::string_view> names) {
    for (const auto& [foreign, own, with] : kWords)
        if (word == foreign && contains(names, own))
            return "this format calls it '" + std::string(own) + "'" + std::string(with);
    if (word == "never" && contains(names, "always"))
        return R"(negate the condition: "that": "not a.x > 1", "when": "always")";
    return nearest_word(word, names).empty() ? "" : suggestion(word, names);
}

}  // namespace tumble::scene
