// Finds the position in a text that a JSON pointer refers to.
#pragma once

#include <cstddef>
#include <string_view>

namespace tumble::scene {

// The offset in bytes at which the value, or its key, begins. The text must have been parsed without error. Of a key
// that occurs twice, the last counts, as in the parser. If the pointer leads beyond what the text contains, the offset
// is that of the innermost value that exists. O(length of the text).
std::size_t find_offset(std::string_view text, std::string_view pointer, bool at_key);

// The offset of the byte that is `inside` bytes from the start of a string, whose opening quote is at `string`. Escapes
// count as the bytes that they stand for. At most the offset of the closing quote.
std::size_t offset_in_string(std::string_view text, std::size_t string, std::size_t inside);

}  // namespace tumble::scene
