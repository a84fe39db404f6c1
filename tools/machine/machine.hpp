// The machine and the build that measurements come from.
#pragma once

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

// The processor's name in /proc/cpuinfo, or "unknown".
std::string processor_name();

// {"processor", "cores", "compiler", "build_type", "simd"}
void write_machine(JsonWriter& json);

}  // namespace tumble::tools
