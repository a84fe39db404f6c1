#include "tools/shrink/scene_parts.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "tumble/scene_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

// Keys that say what or where something is: without them the scene would be another, not a smaller one.
constexpr std::array<std::string_view, 8> kKeptKeys = {"format", "name",     "type",   "position",
                                                       "repeat", "duration", "shapes", "steps_per_second"};

bool is_kept(std::string_view key) { return std::ranges::find(kKeptKeys, key) != kKeptKeys.end(); }

const SceneJson* find(const SceneJson& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

template <class Visit>
void visit_elements(const SceneJson& document, const char* list, Visit visit) {
    const SceneJson* const elements = find(document, list);
    if (!elements) return;
    for (std::size_t i = 0; i < elements->size(); ++i) visit(Pointer() / list / i, (*elements)[i]);
}

// The bodies of the scene, and those that its events create.
template <class Visit>
void visit_bodies(const SceneJson& document, Visit visit) {
    visit_elements(document, "bodies", visit);
    visit_elements(document, "timeline", [&](const Pointer& event, const SceneJson& value) {
        if (const SceneJson* const body = find(value, "spawn")) visit(event / "spawn", *body);
    });
}

template <class Visit>
void visit_shapes(const SceneJson& document, Visit visit) {
    visit_bodies(document, [&](const Pointer& body, const SceneJson& value) {
        const SceneJson* const shapes = find(value, "shapes");
        for (std::size_t i = 0; shapes && i < shapes->size(); ++i) visit(body / "shapes" / i, (*shapes)[i]);
    });
}

void add_points(const Pointer& shape, const SceneJson& value, std::vector<Pointer>& parts) {
    for (const auto& [kind, geometry] : value.items())
        for (const char* key : {"vertices", "points"})
            if (const SceneJson* const points = geometry.is_object() ? find(geometry, key) : nullptr)
                for (std::size_t i = 0; i < points->size(); ++i) parts.push_back(shape / kind / key / i);
}

void add_keys(const Pointer& at, const SceneJson& object, std::vector<Pointer>& parts) {
    for (const auto& [key, value] : object.items())
        if (!is_kept(key)) parts.push_back(at / key);
}

std::vector<Pointer> keys_of(const SceneJson& document) {
    std::vector<Pointer> parts;
    const auto add = [&](const Pointer& at, const SceneJson& value) { add_keys(at, value, parts); };
    for (const char* key : {"$schema", "description", "camera", "custom"})
        if (document.contains(key)) parts.push_back(Pointer() / key);
    if (const SceneJson* const world = find(document, "world")) add(Pointer() / "world", *world);
    if (const SceneJson* const materials = find(document, "materials"))
        for (const auto& [name, material] : materials->items()) add(Pointer() / "materials" / name, material);
    visit_elements(document, "joints", add);
    visit_elements(document, "timeline", add);
    visit_bodies(document, add);
    visit_shapes(document, [&](const Pointer& shape, const SceneJson& value) {
        add(shape, value);
        for (const auto& [kind, geometry] : value.items())
            if (geometry.is_object()) add_keys(shape / kind, geometry, parts);
    });
    return parts;
}

void add_fractions(const Pointer& at, const SceneJson& value, std::vector<Pointer>& numbers) {
    if (value.is_object())
        for (const auto& [key, member] : value.items()) {
            const bool is_of_time = key == "duration" || key == "steps_per_second";
            if (!is_of_time) add_fractions(at / key, member, numbers);
        }
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) add_fractions(at / i, value[i], numbers);
    if (value.is_number_float()) numbers.push_back(at);
}

// Removes what an error of a scene is about. Returns whether there was something to remove.
bool remove_reference(SceneJson& document, const std::string& pointer, std::set<std::string>& elements) {
    for (const char* list : {"/joints/", "/timeline/", "/expect/", "/camera/keys/", "/camera/notes/"})
        if (pointer.starts_with(list)) {
            elements.insert(pointer.substr(0, pointer.find('/', std::string_view(list).size())));
            return true;
        }
    const bool is_of_reference = pointer == "/camera/follow" || pointer.ends_with("/material");
    if (!is_of_reference || !document.contains(Pointer(pointer))) return false;
    const Pointer at(pointer);
    return document[at.parent_pointer()].erase(at.back()) == 1;
}

// In the order of the document: /joints/10 after /joints/9.
std::vector<Pointer> in_order(const std::set<std::string>& elements) {
    std::vector<Pointer> parts;
    for (const std::string& element : elements) parts.emplace_back(element);
    std::ranges::sort(parts, {}, [](const Pointer& part) {
        return std::pair(part.parent_pointer().to_string(), std::strtoull(part.back().c_str(), nullptr, 10));
    });
    return parts;
}

// One turn of repaired_text(), for at most 20 errors. Returns whether anything was removed.
bool repair(SceneJson& document, const std::vector<Diagnostic>& errors) {
    std::set<std::string> elements;
    for (const Diagnostic& error : errors)
        if (!remove_reference(document, error.pointer, elements)) return false;
    document = without(document, in_order(elements));
    return true;
}

}  // namespace

SceneJson document_of(Scene scene) {
    scene.draws.clear();  // the numbers that were drawn stay
    return SceneJson::parse(to_json(scene));
}

std::vector<Pointer> parts_of(const SceneJson& document, PartKind kind) {
    std::vector<Pointer> parts;
    const auto add = [&](const Pointer& at, const SceneJson&) { parts.push_back(at); };
    switch (kind) {
        case PartKind::claims: visit_elements(document, "expect", add); break;
        case PartKind::events: visit_elements(document, "timeline", add); break;
        case PartKind::joints: visit_elements(document, "joints", add); break;
        case PartKind::bodies: visit_elements(document, "bodies", add); break;
        case PartKind::shapes: visit_shapes(document, add); break;
        case PartKind::points:
            visit_shapes(document,
                         [&](const Pointer& shape, const SceneJson& value) { add_points(shape, value, parts); });
            break;
        case PartKind::materials:
            if (const SceneJson* const materials = find(document, "materials"))
                for (const auto& [name, material] : materials->items()) parts.push_back(Pointer() / "materials" / name);
            break;
        case PartKind::keys: return keys_of(document);
    }
    return parts;
}

const char* name_of(PartKind kind) {
    switch (kind) {
        case PartKind::claims: return "claims";
        case PartKind::events: return "events";
        case PartKind::joints: return "joints";
        case PartKind::bodies: return "bodies";
        case PartKind::shapes: return "shapes";
        case PartKind::points: return "points";
        case PartKind::materials: return "materials";
        case PartKind::keys: return "keys";
    }
    return "";
}

SceneJson without(const SceneJson& document, const std::vector<Pointer>& parts) {
    SceneJson rest = document;
    // From the back, so that the indices of the others stay.
    for (std::size_t i = parts.size(); i-- > 0;) {
        SceneJson& parent = rest[parts[i].parent_pointer()];
        if (parent.is_array())
            parent.erase(std::strtoull(parts[i].back().c_str(), nullptr, 10));
        else
            parent.erase(parts[i].back());
    }
    return rest;
}

std::optional<std::string> valid_text(const SceneJson& document) {
    try {
        return to_json(parse_scene(document.dump(), "candidate"));
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

std::optional<std::string> repaired_text(SceneJson& document) {
    for (;;) {
        try {
            return to_json(parse_scene(document.dump(), "candidate"));
        } catch (const SceneError& error) {
            if (!repair(document, error.diagnostics)) return std::nullopt;
        }
    }
}

std::vector<Repeat> repeats_of(const SceneJson& document) {
    std::vector<Repeat> repeats;
    const auto add_count = [&](const Pointer& at, const SceneJson& value, const char* key) {
        const SceneJson* const count = find(value, key);
        if (count && count->is_number_integer() && count->get<std::int64_t>() > 1)
            repeats.back().counts.push_back(at / key);
    };
    const auto add = [&](const Pointer& at, const SceneJson& value) {
        const SceneJson* const repeat = find(value, "repeat");
        if (!repeat) return;
        repeats.push_back({at / "repeat", {}});
        for (const char* key : {"columns", "rows"}) add_count(at / "repeat", *repeat, key);  // of a joint
        for (const auto& [kind, repeater] : repeat->items())
            for (const char* key : {"columns", "rows", "base", "count"})
                if (repeater.is_object()) add_count(at / "repeat" / kind, repeater, key);
    };
    visit_bodies(document, add);
    visit_elements(document, "joints", add);
    return repeats;
}

SceneJson with_single_copies(const SceneJson& document, const Scene& scene, std::size_t index) {
    SceneJson single = document["bodies"][index];
    const bool turns = single["repeat"].dump().find("\"turn\"") != std::string::npos;
    single.erase("repeat");
    single.erase("skin");  // a loop through copies
    SceneJson bodies = SceneJson::array();
    for (std::size_t i = 0; i < index; ++i) bodies.push_back(document["bodies"][i]);
    const SceneWorld built = build_world(scene);
    for (const SceneInstance& copy : built.bodies) {
        if (copy.source != index) continue;
        const auto pose = built.world.state(copy.id).pose;
        if (!copy.name.empty()) single["name"] = copy.name;
        single["position"] = {pose.position.x, pose.position.y};
        if (turns) single["angle"] = double{angle(pose.rotation)} * 180.0 / std::numbers::pi;
        bodies.push_back(single);
    }
    for (std::size_t i = index + 1; i < document["bodies"].size(); ++i) bodies.push_back(document["bodies"][i]);
    SceneJson expanded = document;
    expanded["bodies"] = std::move(bodies);
    return expanded;
}

std::vector<Pointer> fractions_of(const SceneJson& document) {
    std::vector<Pointer> numbers;
    for (const char* key : {"world", "materials", "bodies", "joints", "timeline"})
        if (const SceneJson* const value = find(document, key)) add_fractions(Pointer() / key, *value, numbers);
    return numbers;
}

double rounded(double number, int digits) {
    if (std::abs(number) >= 1e15 || number == 0.0) return number;
    // The digits in front of the point, or minus the zeros behind it: 2 of 12.3, 0 of 0.1, -1 of 0.012.
    const int whole = static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", std::max(0, digits - whole), number);
    double result = number;
    std::from_chars(text, text + std::char_traits<char>::length(text), result);
    return result == 0.0 ? 0.0 : result;
}

SceneSize size_of(const Scene& scene) {
    SceneSize size;
    size.bodies = count_bodies(scene);
    size.joints = count_joints(scene);
    size.events = scene.timeline.size();
    size.claims = scene.expect.size();
    for (const SceneBody& body : scene.bodies) size.shapes += body.shapes.size();
    size.duration = scene.world.duration;
    size.bytes = to_json(scene).size();
    return size;
}

}  // namespace tumble::tools
