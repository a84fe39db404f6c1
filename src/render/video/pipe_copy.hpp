// A pipe whose bytes a thread copies into a file, for a process that writes to standard output.
#pragma once

#include <exception>
#include <thread>

#include "tumble/file.hpp"

namespace tumble::render {

class PipeCopy {
public:
    // The file must live longer. Throws FileError if no pipe can be made.
    explicit PipeCopy(OutputFile& file);
    ~PipeCopy();
    PipeCopy(const PipeCopy&) = delete;
    PipeCopy& operator=(const PipeCopy&) = delete;

    // The end to write to, for a child process.
    int entry() const noexcept { return entry_; }

    // Closes that end in this process.
    void close_entry();

    // Waits until no process can write any more and everything is copied. Throws FileError, or std::bad_alloc. If the
    // file cannot be written, a process that writes to the pipe gets an error.
    void finish();

private:
    void copy(int exit);

    OutputFile& file_;
    int entry_ = -1;
    std::exception_ptr error_;
    std::thread thread_;
};

}  // namespace tumble::render
