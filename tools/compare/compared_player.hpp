// The page that plays two runs beside each other, a part of the page of a comparison.
#pragma once

#include <string>

#include "tools/compare/compared_pictures.hpp"
#include "tools/compare/compared_runs.hpp"

namespace tumble::tools {

// Simulates both runs again and records their states. Empty if one of the runs is a table, which has no shapes, or if
// a run has more states than a replay. `pictures` have its theme and the sides of its frames. Throws as
// StateSource::next().
std::string compared_player(const CompareInputs& inputs, const ComparedRuns& runs, const PairPictures& pictures);

}  // namespace tumble::tools
