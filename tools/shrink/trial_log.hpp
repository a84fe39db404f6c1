// The results of all candidates that were run, in a file that only grows. A search that is started again takes them
// from there, and so continues where it was ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace tumble::tools {

// The 64-bit hash (XXH64) of a text.
std::uint64_t hash_of(std::string_view text);

class TrialLog {
public:
    // What a candidate did. `step` and `claim` are those of the Failure.
    struct Result {
        bool fails = false;  // in the same way as the scene at the start
        std::uint64_t step = 0;
    };

    // Opens the log of a task, or begins one. Throws FileError: also if another process has it open, or, unless
    // `replace` is given, if it is the log of another task. `replace` begins it anew.
    TrialLog(const std::filesystem::path& file, std::uint64_t task, bool replace);
    ~TrialLog();
    TrialLog(const TrialLog&) = delete;
    TrialLog& operator=(const TrialLog&) = delete;

    // Whether there is a log of this task.
    static bool exists(const std::filesystem::path& file, std::uint64_t task);

    std::optional<Result> find(std::uint64_t candidate) const;
    void add(std::uint64_t candidate, const Result& result);  // throws FileError

private:
    void write_line(const std::string& line) const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::unordered_map<std::uint64_t, Result> results_;
};

}  // namespace tumble::tools
