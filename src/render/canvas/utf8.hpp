// Reading UTF-8 one character at a time.
#pragma once

#include <cstdint>
#include <string_view>

#include "debug/check.hpp"
namespace tumble::render {

// Removes the first character from a text that is not empty, and returns its code point; U+FFFD for a byte that
// begins no well-formed sequence.
inline char32_t take_code_point(std::string_view& text) {
    TUMBLE_CHECK(!text.empty());
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    const std::size_t size = lead < 0x80                   ? 1
                             : lead >= 0xf0 && lead < 0xf8 ? 4
                             : lead >= 0xe0                ? 3
                             : lead >= 0xc0                ? 2
                                                           : 0;
    bool well_formed = size != 0 && lead < 0xf8 && size <= text.size();
    for (std::size_t i = 1; well_formed && i < size; ++i) well_formed = (byte(i) & 0xc0) == 0x80;
    if (!well_formed) {
        text.remove_prefix(1);
        return U'\ufffd';
    }
    char32_t code = size == 1 ? lead : static_cast<char32_t>(lead & (0x7f >> size));
    for (std::size_t i = 1; i < size; ++i) code = (code << 6) | static_cast<char32_t>(byte(i) & 0x3f);
    text.remove_prefix(size);
    return code;
}

}  // namespace tumble::render
