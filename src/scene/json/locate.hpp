// From a JSON pointer to a place in the text.
#pragma once

#include <cstddef>
#include <string_view>

namespace tumble::scene {

// Where the value, or its key, begins in a JSON text that has been parsed without error: a small tokenizer walks it
// again. Of a key that occurs twice, the last counts, as in the parser. If the path ends early, the last value that is
// there answers. O(text).
std::size_t find_offset(std::string_view text, std::string_view pointer, bool at_key);

}  // namespace tumble::scene
