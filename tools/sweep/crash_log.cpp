#include "tools/sweep/crash_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>
#include <vector>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

struct CrashSignal {
    int number;
    const char* name;
};
constexpr std::array<CrashSignal, 5> kCrashSignals{
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};
constexpr std::size_t kHandlerStackBytes = 1 << 16;
constexpr std::uint64_t kNoRun = ~std::uint64_t{0};

int log_descriptor = -1;
std::array<struct sigaction, kCrashSignals.size()> earlier_actions{};
thread_local volatile std::uint64_t marked_run = kNoRun;

std::filesystem::path crash_file(const std::filesystem::path& sweep_folder) {
    return sweep_folder / "leases" / "crashes";
}

// Appends "RUN SIGNAL" as a line, by functions that a handler may call.
void append_crash(std::uint64_t run, const char* signal) {
    std::array<char, 48> line{};
    std::size_t start = 24, end = 24;
    do line[--start] = static_cast<char>('0' + run % 10);
    while ((run /= 10) > 0);
    line[end++] = ' ';
    while (*signal != '\0') line[end++] = *signal++;
    line[end++] = '\n';
    [[maybe_unused]] const ssize_t written = ::write(log_descriptor, line.data() + start, end - start);
}

// The earlier action takes the signal when it is sent again: it stays blocked until the handler returns.
void handle_crash(int signal) {
    for (std::size_t i = 0; i < kCrashSignals.size(); ++i) {
        if (kCrashSignals[i].number != signal) continue;
        if (marked_run != kNoRun) append_crash(marked_run, kCrashSignals[i].name);
        ::sigaction(signal, &earlier_actions[i], nullptr);
        ::raise(signal);
    }
}

}  // namespace

CrashLog::CrashLog(const std::filesystem::path& sweep_folder) {
    const std::filesystem::path file = crash_file(sweep_folder);
    log_descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    // Without a folder the sweep is complete, and another process has removed it.
    if (log_descriptor < 0 && errno != ENOENT)
        throw FileError(file, "cannot write: " + std::generic_category().message(errno));
    struct sigaction action {};
    action.sa_handler = handle_crash;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < kCrashSignals.size(); ++i)
        ::sigaction(kCrashSignals[i].number, &action, &earlier_actions[i]);
}

CrashLog::~CrashLog() {
    for (std::size_t i = 0; i < kCrashSignals.size(); ++i)
        ::sigaction(kCrashSignals[i].number, &earlier_actions[i], nullptr);
    if (log_descriptor >= 0) ::close(log_descriptor);
    log_descriptor = -1;
}

std::map<std::uint64_t, std::string> CrashLog::runs_to_skip(const std::filesystem::path& sweep_folder) {
    std::map<std::uint64_t, int> counts;
    std::map<std::uint64_t, std::string> skipped;
    std::ifstream lines(crash_file(sweep_folder));
    std::uint64_t run = 0;
    for (std::string signal; lines >> run >> signal;)
        if (std::ranges::count(kCrashSignals, signal, &CrashSignal::name) > 0 && ++counts[run] >= kMostCrashes)
            skipped[run] = signal;
    return skipped;
}

struct HandlerStack::Saved {
    std::vector<char> bytes;
    stack_t earlier;
};

HandlerStack::HandlerStack() : saved_(new Saved{std::vector<char>(kHandlerStackBytes), {}}) {
    stack_t stack{};
    stack.ss_sp = saved_->bytes.data();
    stack.ss_size = saved_->bytes.size();
    ::sigaltstack(&stack, &saved_->earlier);
}

HandlerStack::~HandlerStack() { ::sigaltstack(&saved_->earlier, nullptr); }

RunMark::RunMark(std::uint64_t run) { marked_run = run; }
RunMark::~RunMark() { marked_run = kNoRun; }

}  // namespace tumble::tools
