// The exit codes of the process, which scripts rely on.
#pragma once

namespace tumble::tools {

enum class ExitCode : int {
    ok = 0,              // the command succeeded and all files are complete
    internal_error = 1,  // a bug, or out of memory
    usage = 2,           // wrong arguments
    invalid_input = 3,   // a scene, a query, a CSV file
    file_system = 4,     // a file is missing, unreadable, exists already, or the disk is full
    rendering = 5,       // OpenGL, its library or the video encoder failed
    diverged = 6,        // a body's state is not finite
    failed = 7,          // a claim does not hold, or a comparison found a difference
    interrupted = 130,   // SIGINT or SIGHUP; 128 + 2, as shells report SIGINT
    terminated = 143,    // SIGTERM; 128 + 15
};

}  // namespace tumble::tools
