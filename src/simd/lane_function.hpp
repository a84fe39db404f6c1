// The declarations of functions on lanes.
#pragma once

// Always inline: lanes must stay in registers between functions, and the compilers' own estimate leaves the larger
// functions out of line.
#define TUMBLE_LANE_FUNCTION [[gnu::always_inline]] inline

// A kernel: every function that it calls is inlined, those of Eigen too. By their own estimate the compilers leave some
// out of line, and lanes are then passed in memory.
#define TUMBLE_LANE_KERNEL [[gnu::flatten]]
