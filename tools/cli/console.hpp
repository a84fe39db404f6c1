// Output of the process: data on standard output; warnings, errors and progress on standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

namespace tumble::tools {

// Writes data to standard output, on a terminal as printable(), or to standard error after give_output_to_file().
// finish_output() reports a failure, such as a full disk when standard output is redirected to a file.
void write_output(std::string_view text);

// Reserves standard output for an output file of the command, which the user has named "-". False if it is reserved
// already.
bool give_output_to_file();

// Whether standard output is reserved.
bool has_file_output();

// Flushes standard output. Throws FileError if any data could not be written.
void finish_output();

// Writes a text to standard error, as printable().
void narrate(std::string_view text);

// Writes "tumble: error: ..." or "tumble: warning: ..." to standard error, coloured on a terminal unless NO_COLOR is
// set.
void report_error(std::string_view message);
void report_warning(std::string_view message);

// The progress of a run as one line on a terminal, redrawn at most ten times a second. Writes nothing elsewhere.
class Progress {
public:
    Progress(std::string_view unit, std::uint64_t total);
    ~Progress();  // clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::uint64_t done);

private:
    using Clock = std::chrono::steady_clock;

    std::string_view unit_;
    std::uint64_t total_;
    bool shown_ = false;
    bool on_terminal_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
};

}  // namespace tumble::tools
