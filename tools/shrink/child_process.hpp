// A copy of this process that does one piece of work, so that a crash or an endless loop ends only the copy.
#pragma once

#include <functional>
#include <string>

#include "tools/measure/stopwatch.hpp"

namespace tumble::tools {

class ChildProcess {
public:
    struct End {
        int exit_code = -1;  // or -1
        int signal = 0;      // that ended it, or 0
        bool timed_out = false;
        std::string answer;  // what it has written to its descriptor
    };

    // Calls `work` in the copy, with a descriptor to write its answer to; standard input and output are empty, and it
    // is in a process group of its own. If `work` returns, the exit code is 0. After `timeout` seconds the group is
    // killed. This process must have one thread. Throws std::system_error.
    ChildProcess(const std::function<void(int answer)>& work, double timeout);
    ~ChildProcess();  // kills the group
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // Whether it has ended; does not wait.
    bool has_ended();

    // After has_ended().
    const End& end() const { return end_; }

    // Returns when it has ended, or soon after the process gets a signal that asks it to end: see is_interrupted().
    const End& wait();

private:
    void take_end(int status);

    int id_ = -1;
    int answer_ = -1;
    double timeout_;
    Stopwatch watch_;
    End end_;
};

// Writes all bytes to a descriptor. Errors are ignored: the reader sees that bytes are missing.
void write_all(int descriptor, const std::string& bytes);

// How long to sleep between two calls of has_ended().
void wait_briefly();

}  // namespace tumble::tools
