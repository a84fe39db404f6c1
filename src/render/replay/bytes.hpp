// Integers as few bytes: seven bits a byte, lowest first, the eighth bit set in all but the last.
#pragma once

#include <cstdint>
#include <string>

namespace tumble::render {

inline void append_varint(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
    bytes += static_cast<char>(value);
}

// Signs alternate, so that small integers of both signs are short: 0, -1, 1, -2 become 0, 1, 2, 3.
inline void append_signed(std::string& bytes, std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    append_varint(bytes, (bits << 1) ^ (value < 0 ? ~std::uint64_t{0} : 0));
}

}  // namespace tumble::render
