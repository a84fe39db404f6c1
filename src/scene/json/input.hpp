// From the bytes of a file to a JSON value: syntax, duplicate keys, depth and size, before anything is interpreted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/json/diagnostics.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

inline constexpr std::size_t kMaxFileBytes = 32u << 20;  // 20 times as much in memory if it is all numbers
inline constexpr std::size_t kMaxDepth = 64;             // of nested arrays and objects; later passes recurse
inline constexpr std::size_t kMaxKeysInObject = 4096;    // looking up a key is linear

// Leaves out a UTF-8 byte-order mark: no column counts it.
std::string_view without_byte_order_mark(std::string_view text);

// The parsed value, // and /* */ comments allowed; nothing, with errors in `diagnostics`, if the text is not JSON, too
// large or too deep. Duplicate keys are errors too, but the value is returned with the last of each. `if_empty` is the
// hint for an empty text.
std::optional<Json> parse_json(std::string_view text, Diagnostics& diagnostics, const std::string& if_empty = "");

}  // namespace tumble::scene
