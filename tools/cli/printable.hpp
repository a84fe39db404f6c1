// What a terminal may be given of a text.
#pragma once

#include <string>
#include <string_view>

namespace tumble::tools {

// The text with a question mark in place of each control character but line feeds and tabs: names in files from
// elsewhere must not command a terminal. Standard error gets its texts so, and standard output if it is a terminal.
std::string printable(std::string_view text);

}  // namespace tumble::tools
