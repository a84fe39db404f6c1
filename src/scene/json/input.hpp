// Parses the bytes of a file to a JSON value and checks syntax, duplicate keys, depth and size.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

inline constexpr std::size_t kMaxFileBytes = 32u << 20;  // a file of numbers takes 20 times as much memory
inline constexpr std::size_t kMaxDepth = 64;             // of nested arrays and objects, because later passes recurse
inline constexpr std::size_t kMaxKeysInObject = 4096;    // because the search for a key is linear

// The text without its UTF-8 byte-order mark, which columns do not count.
std::string_view without_byte_order_mark(std::string_view text);

// The parsed value; // and /* */ comments are allowed. Empty, with errors in `diagnostics`, if the text is not JSON,
// too large or nested too deep. Duplicate keys are errors too, but the value is returned, with the last one of each.
// `if_empty` is the hint for an empty text.
std::optional<Json> parse_json(std::string_view text, Diagnostics& diagnostics, const std::string& if_empty = "");

}  // namespace tumble::scene
