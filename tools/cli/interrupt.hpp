// Ctrl-C and SIGTERM as a question that a loop asks between steps.
#pragma once

namespace tumble::tools {

// From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the process at once.
void catch_interrupts();

bool is_interrupted() noexcept;

}  // namespace tumble::tools
