#include "scene/format/foreign_words.hpp"

#include <algorithm>
#include <utility>

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

std::string hint_for_foreign_word(std::string_view word, std::span<const std::string_view> names) {
    for (const auto& [foreign, own] : kJointTypes)
        if (word == foreign && contains(names, own)) return "this format calls it '" + std::string(own) + "'";
    return {};
}

}  // namespace tumble::scene
