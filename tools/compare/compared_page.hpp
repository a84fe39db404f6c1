// The page of a comparison: both runs in motion, where they part, how far they are apart, their energies, and pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/compare/compared_pictures.hpp"
#include "tools/compare/compared_runs.hpp"

namespace tumble::tools {

// A step that a page shows, and why: "start", "first difference".
struct Moment {
    std::uint64_t step = 0;
    std::string what;
};

// The start, the first difference, the first time that positions are 1 cm and 10 cm apart, the largest distance, and
// the end; each step once.
std::vector<Moment> moments_of(const ComparedRuns& runs);

// `pictures` are those of the moments, or empty; `player` is compared_player() or empty. `title` names what was
// compared.
std::string compared_page(const std::string& title, const ComparedRuns& runs, const std::vector<Moment>& moments,
                          const std::vector<PairPicture>& pictures, const std::string& player, double tolerance);

}  // namespace tumble::tools
