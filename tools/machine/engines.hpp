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

// Box2D v3, in a build that has it.
EngineBuild box2d_v3_engine();

// A line for each; `with_v3` adds Box2D v3.
std::string engines_text(bool with_v3 = false);

// The member "engines": {"tumble": {"version", "build"}, "box2d": {"version", "build"}}, and "box2d_v3" `with_v3`.
void write_engines(JsonWriter& json, bool with_v3 = false);

}  // namespace tumble::tools
