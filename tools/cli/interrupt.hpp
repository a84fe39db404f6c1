// Ctrl-C (SIGINT) and SIGTERM as a flag that a loop reads between steps.
#pragma once

namespace tumble::tools {

// After this call the first SIGINT or SIGTERM sets the flag, and a second one of the same kind ends the process.
void catch_interrupts();

bool is_interrupted() noexcept;

}  // namespace tumble::tools
