// A child process that reads bytes from its standard input.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tumble::render {

class EncoderProcess {
public:
    // Starts a program of the search path, with the descriptor `output` as its standard output; -1: what it writes
    // there is dropped. Throws RenderError if there is none, or no process can be started.
    explicit EncoderProcess(const std::vector<std::string>& command, int output = -1);
    ~EncoderProcess();  // kills it
    EncoderProcess(const EncoderProcess&) = delete;
    EncoderProcess& operator=(const EncoderProcess&) = delete;

    // False if the process does not read any more.
    bool send(std::span<const std::uint8_t> bytes);

    struct End {
        int exit_code = -1;  // -1 if a signal ended it, or if the system does not tell: where SIGCHLD is ignored
        int signal = 0;
        std::string messages{};  // what it wrote to standard error
    };

    // Ends its input and waits for it. Later calls return the same.
    const End& wait();

private:
    pid_t id_ = -1;  // -1: there is none to wait for
    int input_ = -1;
    int messages_ = -1;
    End end_;
};

}  // namespace tumble::render
