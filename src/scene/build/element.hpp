#pragma once

#include <cstddef>
#include <string>

namespace tumble::scene {

// The JSON pointer of a list's element: "/bodies/3".
inline std::string element(const std::string& list, std::size_t index) { return list + '/' + std::to_string(index); }

}  // namespace tumble::scene
