// The colours of frames as variables of the page's style sheet.
#pragma once

#include <string>

namespace tumble::render {

// A rule for each theme: ':root[data-theme="dark"] { --ground: #14191d; ... }'. `outline-share` is a number.
std::string page_colors();

}  // namespace tumble::render
