// What a measurement was made on.
#pragma once

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

// The processor's name as the kernel has it, or "unknown".
std::string processor_name();

// {"processor", "cores", "compiler", "build_type", "simd"}
void write_machine(JsonWriter& json);

}  // namespace tumble::tools
