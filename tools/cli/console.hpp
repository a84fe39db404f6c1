// Output of the process: data on standard output; warnings, errors and progress on standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace tumble::tools {

// Writes data to standard output, on a terminal as printable(), or to standard error after give_output_to_file().
// finish_output() reports a failure, such as a full disk when standard output is redirected to a file.
void write_output(std::string_view text);

// Writes the report of a command in the same way, unless reports are silenced. A file, a list or a JSON document that
// was asked for is no report.
void write_report(std::string_view text);

// Silences reports and progress. Warnings and errors stay.
void be_quiet();

// Reserves standard output for an output file of the command, which the user has named "-". False if it is reserved
// already.
bool give_output_to_file();

// Whether standard output is reserved.
bool has_file_output();

// Flushes standard output. Throws FileError if any data could not be written.
void finish_output();

// Writes a text to standard error, as printable().
void narrate(std::string_view text);

// The same for a text about what the command does, unless progress is silenced.
void narrate_progress(std::string_view text);

// Writes "tumble: error: ..." or "tumble: warning: ..." to standard error, coloured on a terminal unless NO_COLOR is
// set.
void report_error(std::string_view message);
void report_warning(std::string_view message);

// "[######------] 300 of 600 steps, 120 per second, 3 s left": what is done after these seconds, and what is left at
// that rate.
std::string progress_text(std::string_view units, std::uint64_t done, std::uint64_t total, double seconds);

// The progress of work as one line on a terminal, from two seconds after its begin on, redrawn at most ten times a
// second. Writes nothing elsewhere. Threads may share it.
class Progress {
public:
    // The name of the things that are counted, in the plural.
    Progress(std::string_view units, std::uint64_t total);
    ~Progress();  // clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::uint64_t done);

private:
    using Clock = std::chrono::steady_clock;

    static constexpr std::chrono::seconds kPatience{2};

    std::string_view units_;
    std::uint64_t total_;
    bool shown_ = false;
    bool on_terminal_;
    std::mutex mutex_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_ + kPatience;
};

}  // namespace tumble::tools
