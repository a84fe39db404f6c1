// The plan of a sweep from a file or from standard input.
#pragma once

#include <filesystem>
#include <vector>

#include "sweep/plan/plan.hpp"

namespace tumble::tools {

// read_plan(), also from standard input: its scenes are then relative to the current folder.
sweep::Plan read_plan_input(const std::filesystem::path& file, std::uint64_t runs, bool allow_outside,
                            std::vector<Diagnostic>* warnings = nullptr);

// The warnings about a plan, on standard error.
void narrate_warnings(std::vector<Diagnostic> warnings);

}  // namespace tumble::tools
