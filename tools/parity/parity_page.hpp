// The result of a comparison with Box2D as a page for the browser.
#pragma once

#include <string>

#include "tools/parity/parity_report.hpp"

namespace tumble::tools {

// A self-contained HTML document. `what` names what was compared: "Random and hard pairs".
std::string parity_page(const ParityResults& results, const std::string& what);

}  // namespace tumble::tools
