// Runs that ended their process: which they were, so that a sweep does not end at them again and again.
//
// The handlers of the signals of crashes (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) append the run that the thread
// simulates to DIR/leases/crashes, and pass the signal on. A SIGKILL leaves nothing, so that runs of a machine that
// went down are simulated again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace tumble::tools {

// So many crashes in a run mean that it is the run, and it is recorded instead of simulated.
inline constexpr int kMostCrashes = 2;

// There is one at a time. The folder DIR/leases must exist.
class CrashLog {
public:
    explicit CrashLog(const std::filesystem::path& sweep_folder);
    ~CrashLog();
    CrashLog(const CrashLog&) = delete;
    CrashLog& operator=(const CrashLog&) = delete;

    // The runs that crashed kMostCrashes times, and the last signal of each: "SIGSEGV".
    static std::map<std::uint64_t, std::string> runs_to_skip(const std::filesystem::path& sweep_folder);
};

// Gives this thread a second stack, on which the handlers work when the first one has overflown.
class HandlerStack {
public:
    HandlerStack();
    ~HandlerStack();
    HandlerStack(const HandlerStack&) = delete;
    HandlerStack& operator=(const HandlerStack&) = delete;

private:
    struct Saved;
    std::unique_ptr<Saved> saved_;
};

// The run that this thread simulates, while the object exists.
class RunMark {
public:
    explicit RunMark(std::uint64_t run);
    ~RunMark();
    RunMark(const RunMark&) = delete;
    RunMark& operator=(const RunMark&) = delete;
};

}  // namespace tumble::tools
