// Numbers of a scene file that are drawn at random: {"uniform": [1, 2]}, {"normal": [0, 0.1]}, {"choice": [1, 2, 4]}.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scene/json/json.hpp"

namespace tumble::scene {

// What all draws of a file depend on, besides the place of their number.
struct DrawContext {
    std::uint64_t seed = 1;
    std::string part{};  // the prefixes of the includes that lead to the file
};

// The place of a number as the key of its draw: the pointer in `root`, with the names of elements in place of indices,
// so that a new element does not change the draws of others.
std::string draw_key(const Json& root, const std::string& pointer, const DrawContext& context);

// A wrong declaration: what must be there, and the key that is wrong (may be empty).
struct WrongDraw {
    std::string key, message;
};

// `is_in_range` tells whether a number may stand there. Normal draws outside the range are repeated. Throws WrongDraw.
double draw_number(const Json& declaration, const std::string& key, std::uint64_t seed, bool whole,
                   const std::function<bool(double)>& is_in_range);

}  // namespace tumble::scene
