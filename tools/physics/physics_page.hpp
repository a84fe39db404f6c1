// The rows of `tumble physics` as a page for the browser.
#pragma once

#include <string>

#include "tools/physics/physics_report.hpp"

namespace tumble::tools {

// A self-contained HTML document: a summary, then each row with its formula, values and plots.
std::string physics_page(const PhysicsResult& result);

}  // namespace tumble::tools
