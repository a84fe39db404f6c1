// The page of a health report.
#pragma once

#include <string>

#include "tools/health/health_report.hpp"

namespace tumble::tools {

std::string health_page(const HealthReport& report);

}  // namespace tumble::tools
