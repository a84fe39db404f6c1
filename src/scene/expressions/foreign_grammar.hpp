// Signs and functions of other languages, for hints.
#pragma once

#include <string>
#include <string_view>

namespace tumble::scene {

// What to write in place of a sign; empty if it is of no known language.
std::string_view own_word(std::string_view sign);

// Whether it names a contact, as in "ball hits floor".
bool is_touch_word(std::string_view word);

// What to call in place of a function that this grammar does not have.
std::string own_function(const std::string& name);

}  // namespace tumble::scene
