// Splits the text of a JSON object into its members without parsing the values. Each value is then parsed once, by the
// reader of that member, whose errors name the member.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tumble::tools {

struct JsonMember {
    std::string_view key;    // without its quotes, escapes not resolved
    std::string_view value;  // as written
};

// Empty if the text is not an object, judged by its quotes, brackets, commas and colons. The values themselves may
// still be invalid.
std::optional<std::vector<JsonMember>> split_members(std::string_view object);

}  // namespace tumble::tools
