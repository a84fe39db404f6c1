// Values as R.U.B.E. writes them: missing values are 0, floats may be hexadecimal bit patterns, vectors may be a bare
// 0. Keys that the importer never reads are noted, so that nothing is dropped silently.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/format/field.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"
#include "tumble/scene_import.hpp"

namespace tumble::scene {

// Features that could not be carried over, with counts, in the order of their first occurrence.
class RubeNotes {
public:
    void add(const std::string& feature, int count = 1);
    // The same for a feature of this body or joint: "body 'wheel'".
    void add_of(const std::string& owner, const std::string& feature, int count = 1);
    std::vector<ImportNote> take() { return std::move(notes_); }

private:
    ImportNote& note_of(const std::string& feature);

    std::vector<ImportNote> notes_;
};

// One JSON object and its pointer. A value of the wrong type or out of its range is an error in the diagnostics and
// reads as 0 or missing.
class RubeObject {
public:
    RubeObject(const Json& value, std::string pointer, Diagnostics& diagnostics);

    bool has(std::string_view key) const { return value_.contains(key); }
    const std::string& pointer() const { return pointer_; }
    std::string pointer_to(std::string_view key) const;

    double number(std::string_view key, double missing = 0.0, const Range& range = kForce);
    bool flag(std::string_view key, bool missing = false);
    std::string text(std::string_view key);
    DVec2 vector(std::string_view key, const Range& range = kCoordinate);
    std::vector<DVec2> points(std::string_view key);  // in coordinates of a body
    // The JSON text of an object with these keys, empty if all are missing.
    std::string custom(std::initializer_list<std::string_view> keys);
    RubeObject object(std::string_view key);
    std::vector<RubeObject> list(std::string_view key);

    // An index into the `end` elements of a list, which `of` names ("bodies"). -1, with an error, if it is out of
    // range.
    int index(std::string_view key, std::size_t end, const std::string& of);

    // Marks keys as read that are redundant or have no effect.
    void skip(std::initializer_list<std::string_view> keys);

    // Notes the keys that were never read, as "<kind> key '<key>'".
    void note_unread(const std::string& kind, RubeNotes& notes) const;

    void warn(std::string_view key, std::string message, std::string hint = "");

private:
    const Json* find(std::string_view key);
    double to_number(const Json& value, const std::string& pointer, const Range& range);
    void error(const std::string& pointer, const std::string& wanted, const Json& got);

    const Json& value_;
    std::string pointer_;
    Diagnostics& diagnostics_;
    std::set<std::string, std::less<>> read_;
};

}  // namespace tumble::scene
