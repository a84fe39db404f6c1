// Hints for keys and words that other engines and their file formats use.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/json/json.hpp"

namespace tumble::scene {

// How this format expresses `key` in an object whose keys are `known`; empty if no hint is known.
std::string_view hint_for_foreign_key(std::string_view key, std::span<const std::string_view> known);

// What this format calls `word`, which should have been one of `names`, else the nearest of them; empty if
// there is neither.
std::string hint_for_foreign_word(std::string_view word, std::span<const std::string_view> names);

// How this format writes a value of another kind, as of a number that has a unit or an object that was given as a
// number. `key` is that of the value, or for an element that of its list; `wanted` is the kind, as messages call it.
// Empty if no hint is known.
std::string hint_for_wrong_value(std::string_view key, std::string_view wanted, const Json& value);

// The digits of a colour that was given by its name, else an example.
std::string hint_for_color(std::string_view name);

}  // namespace tumble::scene
