// Bodies and joints that something in a scene speaks of by name: found, or an error that names those there are.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene/json/diagnostics.hpp"
#include "scene/model/names.hpp"

namespace tumble::scene {

// `key`, below `pointer`, is where the name stands. An empty name is a missing key.
class References {
public:
    // With `bodies_unread` some names are not known, and none is called missing.
    References(const Scene& scene, const BodyNames& names, bool bodies_unread, Diagnostics& diagnostics)
        : scene_(scene), names_(names), joint_names_(scene), bodies_unread_(bodies_unread), diagnostics_(diagnostics) {}

    // The built body that is there from the start.
    std::optional<std::size_t> body(const std::string& name, const std::string& pointer, const std::string& key) const;

    // A body that is there from the start, or made by the timeline.
    void any_body(const std::string& name, const std::string& pointer, const std::string& key) const;

    // The same, or the common name of copies.
    void body_or_copies(const std::string& name, const std::string& pointer, const std::string& key) const;

    // Of repeated joints a copy; where all are meant, `or_all`, their common name too. Null if there is none.
    const SceneJoint* joint(const std::string& name, const std::string& pointer, const std::string& key,
                            bool or_all = false) const;

    const JointNames& joint_names() const { return joint_names_; }

private:
    const Scene& scene_;
    const BodyNames& names_;
    const JointNames joint_names_;
    bool bodies_unread_;
    Diagnostics& diagnostics_;
};

}  // namespace tumble::scene
