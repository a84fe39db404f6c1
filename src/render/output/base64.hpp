// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace tumble::render {

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace tumble::render
