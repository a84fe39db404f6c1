// Numbers as the header of a replay writes them.
#pragma once

#include <nlohmann/json.hpp>

#include <span>
#include <string>

#include "render/style/color.hpp"
#include "tumble/math.hpp"

namespace tumble::render {

// The double nearest to the number's first seven digits: what float keeps, in few characters.
double brief(double number);

// x0, y0, x1, y1, ... in full.
nlohmann::ordered_json numbers(std::span<const DVec2> points);

// "#rrggbb"
std::string to_hex(Color color);

}  // namespace tumble::render
