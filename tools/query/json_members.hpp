// Splits the text of a JSON object into its members without reading their values. Each value is then read once, by the
// reader of its kind, which reports the position of an error in it.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tumble::tools {

struct JsonMember {
    std::string_view key;    // without its quotes, escapes not resolved
    std::string_view value;  // as written
};

// Nothing if the text is not an object by its quotes, brackets, commas and colons. The values may still be wrong.
std::optional<std::vector<JsonMember>> split_members(std::string_view object);

}  // namespace tumble::tools
