// The engines of a comparison: their versions, and how each was compiled. Every table of a comparison states them.
#pragma once

#include <array>
#include <string>

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

struct EngineBuild {
    std::string name;     // "Box2D"
    std::string version;  // "2.4.1"
    std::string build;    // compiler, flags and instruction set
};

// tumble, with the instruction set that it has chosen for this processor, and Box2D.
std::array<EngineBuild, 2> compared_engines();

// A line for each.
std::string engines_text();

// The member "engines": {"tumble": {"version", "build"}, "box2d": {"version", "build"}}
void write_engines(JsonWriter& json);

}  // namespace tumble::tools
