// Which built body or joint a name means: "crate", or "crate[3]" for a copy.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

// What a name means: an entry of a list of the scene, and which of its copies.
struct NamedCopy {
    std::size_t source = 0;
    std::size_t copy = 0;
    std::size_t count = 1;  // of all copies
    bool is_copy = false;

    friend bool operator==(const NamedCopy&, const NamedCopy&) = default;
};

// The names of a list's entries: of a repeated one "crate[3]" names something, and "crate" all its copies.
class EntryNames {
public:
    // Of two entries with one name, the first counts; an empty name is none.
    void add(const std::string& name, const NamedCopy& first);

    std::optional<NamedCopy> find(std::string_view name) const;

    // Of a repeated entry alone.
    std::optional<NamedCopy> find_copy(std::string_view name) const;

    // The entry that has this name, repeated or not.
    std::optional<std::size_t> find_source(std::string_view name) const;

    bool is_shared(std::string_view name) const;

    // "crate[0] to crate[9]"; empty if no copies share the name.
    std::string copies_text(std::string_view name) const;

    void append_to(std::vector<std::string_view>& names) const;

private:
    std::map<std::string, NamedCopy, std::less<>> first_;  // the first copy of each
};

class BodyNames {
public:
    // Counts the copies of every body.
    explicit BodyNames(const Scene& scene);

    // The index of a built body, counting copies, in the order in which they are built.
    std::optional<std::size_t> find(std::string_view name) const;

    // The entry of Scene::bodies that has this name, repeated or not.
    std::optional<std::size_t> find_source(std::string_view name) const { return entries_.find_source(name); }

    // Whether the timeline makes a body of this name.
    bool is_spawned(std::string_view name) const;

    // The entry of Scene::timeline that does, or makes copies that share it.
    std::optional<std::size_t> find_event(std::string_view name) const;

    // Whether copies share this name, of a body that is repeated or made by the timeline more than once.
    bool is_shared(std::string_view name) const;

    // Whether a copy of a repeated body has this name.
    bool is_copy(std::string_view name) const { return entries_.find_copy(name).has_value(); }

    // How many copies of the same body come after this one; nothing if the name is not a copy's.
    std::optional<std::size_t> copies_after(std::string_view name) const;

    // Why `name` names nothing that is there from the start, for a hint; may be empty.
    std::string hint(std::string_view name) const;

private:
    struct Spawned {
        std::size_t event = 0;
        bool again = false;  // it makes more than one
    };

    EntryNames entries_;
    std::vector<std::size_t> first_built_;  // [Scene::bodies]: the built body that is its first copy
    std::map<std::string, Spawned, std::less<>> spawned_;
};

// The body that has a name in the end: an entry of Scene::bodies, repeated or not, or what an event spawns. Null if
// none.
const SceneBody* find_definition(const Scene& scene, const BodyNames& names, std::string_view name);

class JointNames {
public:
    explicit JointNames(const Scene& scene);

    // "hinge", or "hinge[3]" of a repeated one: an entry of Scene::joints.
    std::optional<NamedCopy> find(std::string_view name) const { return entries_.find(name); }

    // The entry of Scene::joints that has this name, repeated or not.
    std::optional<std::size_t> find_source(std::string_view name) const { return entries_.find_source(name); }

    // The index in SceneWorld::joints, where gears follow all other joints.
    std::size_t built_index(const NamedCopy& joint) const { return first_built_[joint.source] + joint.copy; }

    // Why `name` names nothing, for a hint; may be empty.
    std::string hint(std::string_view name) const;

private:
    EntryNames entries_;
    std::vector<std::size_t> first_built_;  // [Scene::joints]: the built joint that is its first copy
};

// "crate[3]"; empty for an empty name.
std::string copy_name(const SceneBody& body, std::size_t copy);
std::string copy_name(const SceneJoint& joint, std::size_t copy);
std::string copy_name(const std::string& name, std::size_t copy);

// 3 of "crate[3]"; nothing of any other name.
std::optional<std::size_t> copy_number(std::string_view name);

// "crate" of "crate[3]"; any other name itself.
std::string_view base_name(std::string_view name);

}  // namespace tumble::scene
