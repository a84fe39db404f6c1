// What a person or a script sees: data on standard output, everything else on standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

namespace tumble::tools {

// Data. A failure (a full disk behind a redirection) is found by finish_output().
void write_output(std::string_view text);

// Throws FileError if any of the data could not be written.
void finish_output();

// Narration, one line or more, as it is.
void narrate(std::string_view text);

// "tumble: error: ..." and "tumble: warning: ...", coloured on a terminal unless NO_COLOR is set.
void report_error(std::string_view message);
void report_warning(std::string_view message);

// One line on a terminal that says how far a run is; silent elsewhere. Redrawn at most ten times a second.
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
