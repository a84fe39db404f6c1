// Splits the text of a JSON object into its members without reading their values: each value is then read once, by
// whoever knows what it is and can say where in it an error is.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tumble::tools {

struct JsonMember {
    std::string_view key;    // without its quotes, escapes not resolved
    std::string_view value;  // as written
};

// Nothing if the text is not an object, as far as its quotes, brackets, commas and colons tell: the values themselves
// may still be wrong.
std::optional<std::vector<JsonMember>> split_members(std::string_view object);

}  // namespace tumble::tools
