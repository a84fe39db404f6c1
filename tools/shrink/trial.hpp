// One run of a candidate: what fails in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/shrink/child_process.hpp"
#include "tools/shrink/failure.hpp"

namespace tumble::tools {

// How candidates are run.
struct TrialSettings {
    std::string command = "check";  // or a command of the shell, with {} for the file of the scene
    double timeout = 60.0;          // s of one run
    bool same_output = false;       // of a command: the first line of its standard error belongs to the failure
    bool any_body = false;          // of `check`: a finding may be about other bodies and joints

    bool is_check() const { return command == "check"; }
};

// The command for the shell: each {} becomes "$1", the first argument.
std::string shell_command(const std::string& command);

class Trial {
public:
    // Starts a run of the scene with this canonical text. For a command it is written to `file` first. Throws
    // FileError.
    Trial(const std::string& text, const TrialSettings& settings, const std::filesystem::path& file);

    bool has_ended() { return process_.has_ended(); }

    // After has_ended(): one failure for a command, or none; all failures for `check`.
    std::vector<Failure> failures() const;

private:
    std::vector<Failure> failures_of_command() const;

    const TrialSettings& settings_;
    std::filesystem::path file_;
    ChildProcess process_;
};

// Runs it and waits. No failures if a signal has asked this process to end.
std::vector<Failure> run_trial(const std::string& text, const TrialSettings& settings,
                               const std::filesystem::path& file);

}  // namespace tumble::tools
