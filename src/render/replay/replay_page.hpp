// Puts packed bytes into the page.
#pragma once

#include <string>
#include <string_view>

namespace tumble::render {

// The whole HTML page, whose script unpacks `states` and `contacts`. Both are compressed; base64 keeps whatever names
// they contain out of the markup.
std::string replay_page(std::string_view states, std::string_view contacts);

}  // namespace tumble::render
