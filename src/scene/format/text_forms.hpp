// The forms of texts that are not names: colours and hashes.
#pragma once

#include <string>

namespace tumble::scene {

// #rgb or #rrggbb.
inline bool is_color(const std::string& text) {
    return (text.size() == 4 || text.size() == 7) && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

// A state hash: 16 digits 0-9 and a-f.
inline bool is_hash(const std::string& text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace tumble::scene
