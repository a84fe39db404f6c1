// The declarations of functions on lanes.
#pragma once

// Always inline: lanes must stay in registers between functions, and the compilers' own estimate leaves the larger
// functions out of line.
#define TUMBLE_LANE_FUNCTION [[gnu::always_inline]] inline

// A function that the others are inlined into, those of Eigen too: the compilers' estimate leaves some of them out of
// line, and lanes then pass through memory.
#define TUMBLE_LANE_KERNEL [[gnu::flatten]]
