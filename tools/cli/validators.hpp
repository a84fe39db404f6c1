// The numbers that options take: unlike by the library's own checks not NaN, and no -1 that wraps around.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>

namespace tumble::tools {

// Both ends included.
CLI::Validator number_from_to(double lowest, double highest);
CLI::Validator whole_number_from_to(std::uint64_t lowest, std::uint64_t highest);

// Whole numbers from 0 on.
CLI::Validator any_seed();

}  // namespace tumble::tools
