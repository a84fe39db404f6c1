// Asks candidates whether they fail in the same way as the scene at the start: several at once, each once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "tools/shrink/trial.hpp"
#include "tools/shrink/trial_log.hpp"

namespace tumble::tools {

// Ends a search after a signal.
struct SearchInterrupted {};

class Candidates {
public:
    // `wanted` is the text of the failure. `folder` is for the files of candidates.
    Candidates(TrialSettings settings, std::string wanted, int jobs, std::filesystem::path folder, TrialLog& log);

    // The canonical text of a candidate, or nothing if it is no valid scene: then it does not fail the same.
    using Make = std::function<std::optional<std::string>(std::size_t index)>;

    // The index of the first of `count` candidates that fails the same, or `count`. Later ones may be run before
    // earlier ones have ended, which does not change the answer. Throws SearchInterrupted and FileError.
    std::size_t first_failing(std::size_t count, const Make& make);

    // Of the candidate that first_failing() found last.
    const std::string& text() const { return text_; }
    std::uint64_t step() const { return step_; }  // that decided its failure

    // The candidates whose results were needed so far, with those from the log; and those that were run, with those
    // whose results were not needed.
    std::size_t run_count() const { return needed_.size(); }
    std::size_t new_run_count() const { return new_run_count_; }

private:
    struct Asked {
        std::optional<std::string> text;
        std::uint64_t hash = 0;
        std::optional<TrialLog::Result> result;
        std::unique_ptr<Trial> trial;
        std::size_t slot = 0;
    };

    Asked ask(std::size_t index, const Make& make);
    void start(Asked& asked);
    void take_results(std::vector<Asked>& asked);
    std::filesystem::path file_of(std::size_t slot) const;

    TrialSettings settings_;
    std::string wanted_;
    std::filesystem::path folder_;
    TrialLog& log_;
    std::vector<bool> busy_;  // [jobs]
    std::unordered_set<std::uint64_t> needed_;
    std::size_t new_run_count_ = 0;
    std::string text_;
    std::uint64_t step_ = 0;
};

}  // namespace tumble::tools
