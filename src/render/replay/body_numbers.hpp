// Which body of a replay an id means. World reuses the index of a body that was destroyed, with another generation:
// only the whole id tells bodies apart.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "tumble/world.hpp"

namespace tumble::render {

using BodyNumbers = std::map<BodyId, std::uint32_t>;

// Nothing for a body that is not one of the scene's.
inline std::optional<std::uint32_t> find_number(const BodyNumbers& numbers, BodyId id) {
    const auto found = numbers.find(id);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace tumble::render
