// Which built body or joint a name refers to. The copies of a repeated body "crate" are called "crate[0]", "crate[1]",
// ...; "crate" is their common name. Claims accept a common name for all copies; all other keys need one body or copy.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debug/check.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

// What a name refers to: an entry of a list of the scene, and one of its copies.
struct NamedCopy {
    std::size_t source = 0;
    std::size_t copy = 0;
    std::size_t count = 1;  // of all copies
    bool is_copy = false;   // of a repeated entry

    friend bool operator==(const NamedCopy&, const NamedCopy&) = default;
};

// The names of the entries of one list.
class EntryNames {
public:
    // Of two entries with one name, the first counts. An entry with an empty name has no name.
    void add(const std::string& name, const NamedCopy& first);

    // An entry that is not repeated, or a copy of one that is.
    std::optional<NamedCopy> find(std::string_view name) const;

    // A copy of a repeated entry.
    std::optional<NamedCopy> find_copy(std::string_view name) const;

    // The entry that has this name, repeated or not.
    std::optional<std::size_t> find_source(std::string_view name) const;

    // Whether the name is the common name of copies.
    bool is_shared(std::string_view name) const;

    // "crate[0] to crate[9]"; empty if it is not the common name of copies.
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

    // Whether the timeline spawns a body of this name.
    bool is_spawned(std::string_view name) const;

    // The entry of Scene::timeline that spawns a body of this name, or copies of which it is the common name.
    std::optional<std::size_t> find_event(std::string_view name) const;

    // Whether the name is the common name of copies, of a repeated body or of one that the timeline spawns several
    // times.
    bool is_shared(std::string_view name) const;

    // Whether a copy of a repeated body has this name.
    bool is_copy(std::string_view name) const { return entries_.find_copy(name).has_value(); }

    // How many copies of the same body follow this one; nothing if the name is not that of a copy.
    std::optional<std::size_t> copies_after(std::string_view name) const;

    // The number of bodies that are there from the start, copies included.
    std::size_t built_count() const { return built_count_; }

    // Why no body has this name at the start, for a hint; may be empty.
    std::string hint(std::string_view name) const;

private:
    struct Spawned {
        std::size_t event = 0;
        bool repeats = false;  // it spawns more than one body
    };

    EntryNames entries_;
    std::vector<std::size_t> first_built_;  // [Scene::bodies]: the built body that is its first copy
    std::size_t built_count_ = 0;
    std::map<std::string, Spawned, std::less<>> spawned_;
};

// The definition of the body or copies of a name: an entry of Scene::bodies, or the body that an event spawns. Null if
// there is none.
const SceneBody* find_definition(const Scene& scene, const BodyNames& names, std::string_view name);

class JointNames {
public:
    explicit JointNames(const Scene& scene);

    // "hinge", or "hinge[3]" of a repeated one: an entry of Scene::joints.
    std::optional<NamedCopy> find(std::string_view name) const { return entries_.find(name); }

    // The entry of Scene::joints that has this name, repeated or not.
    std::optional<std::size_t> find_source(std::string_view name) const { return entries_.find_source(name); }

    // Whether the name is the common name of the copies of a repeated joint.
    bool is_shared(std::string_view name) const { return entries_.is_shared(name); }

    // The index in SceneWorld::joints, where gears follow all other joints.
    std::size_t built_index(const NamedCopy& joint) const {
        TUMBLE_CHECK(joint.source < first_built_.size());
        TUMBLE_CHECK(joint.copy < joint.count);
        return first_built_[joint.source] + joint.copy;
    }

    // Why no joint has this name, for a hint; may be empty.
    std::string hint(std::string_view name) const;

private:
    EntryNames entries_;
    std::vector<std::size_t> first_built_;  // [Scene::joints]: the built joint that is its first copy
};

// "crate[3]"; empty for an empty name.
std::string copy_name(const SceneBody& body, std::size_t copy);
std::string copy_name(const SceneJoint& joint, std::size_t copy);
std::string copy_name(const std::string& name, std::size_t copy);

// 3 for "crate[3]"; nothing for any other name.
std::optional<std::size_t> copy_number(std::string_view name);

// "crate" for "crate[3]"; any other name itself.
std::string_view base_name(std::string_view name);

}  // namespace tumble::scene
