// Looks up the bodies and joints that a scene refers to by name, and reports those that are missing with the nearest
// known name.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene/build/resolved_scene.hpp"
#include "scene/expressions/program.hpp"
#include "scene/json/diagnostics.hpp"

namespace tumble::scene {

// The name is the value at `key` below `pointer`. An empty name is a missing key.
class References {
public:
    // If bodies or joints are unread, some names are unknown, and none is reported as missing.
    References(const Scene& scene, const ResolvedScene& resolved, Diagnostics& diagnostics)
        : scene_(scene), resolved_(resolved), diagnostics_(diagnostics) {}

    // The index of the built body, for bodies that are there from the start.
    std::optional<std::size_t> body(const std::string& name, const std::string& pointer, const std::string& key) const;

    // A body that is there from the start or spawned by the timeline.
    void any_body(const std::string& name, const std::string& pointer, const std::string& key) const;

    // The same, or the common name of copies.
    void body_or_copies(const std::string& name, const std::string& pointer, const std::string& key) const;

    // The entry of a joint, for a repeated one by the name of a copy; with `or_all` by the common name of its copies
    // too. Null if there is none.
    const SceneJoint* joint(const std::string& name, const std::string& pointer, const std::string& key,
                            bool or_all = false) const;

    // The body of that name, spawned or not; null if there is none. Reports nothing.
    const SceneBody* definition(const std::string& name) const {
        return find_definition(scene_, resolved_.body_names, name);
    }

    // The names that expressions may use. Nothing if bodies or joints are unread: then no name is reported.
    std::optional<KnownNames> known_names() const;

private:
    const Scene& scene_;
    const ResolvedScene& resolved_;
    Diagnostics& diagnostics_;
};

}  // namespace tumble::scene
