// Colours of SVG in the form of scene files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tumble::scene {

// "#rrggbb" for #rgb, #rrggbb, either with alpha (which is dropped), rgb() and rgba(), and the names of CSS; nothing
// for anything else.
std::optional<std::string> parse_color(std::string_view text);

}  // namespace tumble::scene
