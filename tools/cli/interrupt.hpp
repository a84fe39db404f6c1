// Ctrl-C (SIGINT), the end of the terminal (SIGHUP) and SIGTERM as a flag that a loop reads between steps.
#pragma once

#include "tools/cli/exit_code.hpp"

namespace tumble::tools {

// After this call the first SIGINT, SIGHUP or SIGTERM sets the flag, and a second one of the same kind ends the
// process. A SIGHUP that the process was started to ignore (nohup) stays ignored. A write to a pipe whose
// reader has ended fails, so that the process can remove what it has not completed.
void catch_interrupts();

bool is_interrupted() noexcept;

// `terminated` after a SIGTERM, else `interrupted`.
ExitCode interruption_code() noexcept;

}  // namespace tumble::tools
