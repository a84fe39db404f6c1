#include "scene/build/validate_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scene/build/element.hpp"
#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

class NameValidator {
public:
    NameValidator(const Scene& scene, const SceneSizes& own, const BodyNames& names, Diagnostics& diagnostics)
        : scene_(scene), own_(own), names_(names), diagnostics_(diagnostics) {}

    void validate_bodies() {
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
            const SceneBody& body = scene_.bodies[i];
            if (body.name.empty()) continue;
            const std::string pointer = element("/bodies", i) + "/name";
            const std::size_t first = *names_.find_source(body.name);
            if (first != i)
                diagnostics_.error(
                    pointer,
                    quoted(body.name) + " is already the name of " + diagnostics_.name_of(element("/bodies", first)),
                    prefix_hint(i, own_.bodies));
            else if (!body.repeat && names_.is_copy(body.name))
                diagnostics_.error(pointer, quoted(body.name) + " is already the name of a copy of a repeated body");
        }
    }

    void validate_joints() {
        std::set<std::string_view> repeated, earlier;
        for (const SceneJoint& joint : scene_.joints)
            if (joint.repeat) repeated.insert(joint.name);
        for (std::size_t i = 0; i < scene_.joints.size(); ++i) {
            const std::string& name = scene_.joints[i].name;
            const std::string pointer = element("/joints", i) + "/name";
            if (copy_number(name) && repeated.contains(base_name(name)))
                diagnostics_.error(pointer, quoted(name) + " is reserved for a copy of a repeated joint");
            if (!name.empty() && !earlier.insert(name).second)
                diagnostics_.error(pointer, quoted(name) + " is already the name of another joint",
                                   prefix_hint(i, own_.joints));
        }
    }

    void validate_spawns() {
        std::map<std::string_view, std::set<double>> ends;  // s: when bodies of a name are despawned
        std::set<std::string_view> repeated;
        for (const SceneEvent& event : scene_.timeline) {
            if (event.at && !event.despawn.empty()) ends[event.despawn].insert(*event.at);
            if (event.spawn && (event.every || event.spawn->repeat)) repeated.insert(event.spawn->name);
        }
        std::map<std::string_view, std::size_t> last;  // the last event that spawns a body of a name
        for (std::size_t i = 0; i < scene_.timeline.size(); ++i) {
            const SceneEvent& event = scene_.timeline[i];
            if (!event.spawn || event.spawn->name.empty()) continue;
            const std::string& name = event.spawn->name;
            const auto refuse = [&](const std::string& reason, const std::string& hint = "") {
                diagnostics_.error(element("/timeline", i) + "/spawn/name", quoted(name) + " is " + reason, hint);
            };
            const auto [earlier, is_new] = last.try_emplace(name, i);
            const std::size_t other = std::exchange(earlier->second, i);
            if (names_.find_source(name) || names_.is_copy(name))
                refuse("already the name of a body that exists from the start", prefix_hint(i, own_.timeline));
            else if (copy_number(name) && repeated.contains(base_name(name)))
                refuse("reserved for a copy that the timeline spawns");
            else if (!is_new && !ends_between(scene_.timeline[other], event, ends[name]))
                refuse("already the name of the body that " + diagnostics_.name_of(element("/timeline", other)) +
                           " spawns",
                       i < own_.timeline ? "a name is free again once its body was despawned"
                                         : prefix_hint(i, own_.timeline));
        }
    }

private:
    static std::string prefix_hint(std::size_t index, std::size_t own) {
        return index < own ? "" : R"(give the included file a "prefix" for its names)";
    }

    static bool ends_between(const SceneEvent& one, const SceneEvent& other, const std::set<double>& ends) {
        if (!one.at || !other.at || one.spawn->repeat || other.spawn->repeat) return false;
        const auto end = ends.lower_bound(std::min(*one.at, *other.at));
        return end != ends.end() && *end <= std::max(*one.at, *other.at);
    }

    const Scene& scene_;
    const SceneSizes& own_;
    const BodyNames& names_;
    Diagnostics& diagnostics_;
};

}  // namespace

void validate_names(const Scene& scene, const SceneSizes& own, const BodyNames& names, Diagnostics& diagnostics) {
    NameValidator validator(scene, own, names, diagnostics);
    validator.validate_bodies();
    validator.validate_joints();
    validator.validate_spawns();
}

}  // namespace tumble::scene
