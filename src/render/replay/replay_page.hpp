// Puts packed bytes into the page.
#pragma once

#include <string>
#include <string_view>

namespace tumble::render {

// The whole HTML page, whose script unpacks `states` and `contacts`. Both are compressed; base64 keeps whatever names
// they contain out of the markup.
std::string replay_page(std::string_view states, std::string_view contacts);

// The page of two runs; `numbers` is JSON, see pair_json().
std::string pair_page(std::string_view states_a, std::string_view states_b, std::string_view numbers);

}  // namespace tumble::render
