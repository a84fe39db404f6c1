// The instruction set that the simulation uses. A library for x86-64 contains the simulation for several, and chooses
// the last that the processor has when the program starts. The results are the same bits on all.
#pragma once

#include <string>
#include <vector>

namespace tumble {

// "baseline", "avx2" or "avx512". The environment variable TUMBLE_SIMD, if it is set to one of these names when the
// program starts, chooses it.
std::string instruction_set();

// All that the library contains and the processor has, from "baseline" on.
std::vector<std::string> instruction_sets();

// Why TUMBLE_SIMD could not be obeyed, so that the library has chosen by itself; empty if there is no reason. A program
// that must not run with another instruction set than the one asked for checks this first.
std::string instruction_set_error();

}  // namespace tumble
