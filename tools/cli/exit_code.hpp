// What the process tells the script that started it.
#pragma once

namespace tumble::tools {

enum class ExitCode : int {
    ok = 0,              // everything that was promised is done
    internal_error = 1,  // a bug, or a processor that the build does not fit
    usage = 2,
    invalid_input = 3,  // a scene, or the text of a query
    file_system = 4,    // unreadable, exists already, disk full
    rendering = 5,
    diverged = 6,       // the simulation is no longer finite
    failed = 7,         // an expectation or a comparison
    interrupted = 130,  // SIGINT or SIGTERM: 128 + 2, as shells have it
};

}  // namespace tumble::tools
