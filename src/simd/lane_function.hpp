// How functions of lanes are declared.
#pragma once

// For functions of lanes in inner loops: they are worth it only if their lanes stay in registers, and the compiler's
// own estimate leaves the larger ones out of line.
#define TUMBLE_LANE_FUNCTION [[gnu::always_inline]] inline
