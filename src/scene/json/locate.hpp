// Finds the position in a text that a JSON pointer refers to.
#pragma once

#include <cstddef>
#include <string_view>

namespace tumble::scene {

// The offset in bytes at which the value, or its key, begins. The text must have been parsed without error. Of a key
// that occurs twice, the last counts, as in the parser. If the pointer leads beyond what the text contains, the offset
// is that of the innermost value that exists. O(length of the text).
std::size_t find_offset(std::string_view text, std::string_view pointer, bool at_key);

}  // namespace tumble::scene
