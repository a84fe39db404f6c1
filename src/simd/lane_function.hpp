// The declaration of functions on lanes.
#pragma once

// Always inline: lanes must stay in registers between functions, and the compilers' own estimate leaves the larger
// functions out of line.
#define TUMBLE_LANE_FUNCTION [[gnu::always_inline]] inline
