// What a page of two runs says of their differences.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tumble/recording.hpp"

namespace tumble::render {

// `title`, `names` of both, `first` (the step of the first difference, or null), and for each step `distances` (m) and
// `energies` of both (J), with null for a number that is not finite.
nlohmann::ordered_json pair_json(const ReplayPair& pair);

}  // namespace tumble::render
