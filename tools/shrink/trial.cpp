#include "tools/shrink/trial.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <functional>
#include <sstream>

#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

// One line for each failure: its step, its claim, its text.
std::string to_lines(std::vector<Failure> failures) {
    std::string lines;
    for (Failure& failure : failures) {
        std::ranges::replace(failure.text, '\n', ' ');
        lines += std::to_string(failure.step) + " " + std::to_string(failure.claim) + " " + failure.text + "\n";
    }
    return lines;
}

std::vector<Failure> from_lines(const std::string& lines) {
    std::vector<Failure> failures;
    std::istringstream stream(lines);
    for (Failure failure;
         stream >> failure.step >> failure.claim && stream.get() == ' ' && std::getline(stream, failure.text);)
        failures.push_back(failure);
    return failures;
}

void check_in_copy(const std::string& text, bool any_body, int answer) {
    write_all(answer, to_lines(find_failures(parse_scene(text, "candidate"), any_body)));
}

void run_in_copy(const std::string& command, const std::string& file, int answer) {
    ::dup2(answer, STDERR_FILENO);
    ::execl("/bin/sh", "sh", "-c", command.c_str(), "sh", file.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
}

std::function<void(int)> work_of(const std::string& text, const TrialSettings& settings,
                                 const std::filesystem::path& file) {
    if (settings.is_check()) return [&](int answer) { check_in_copy(text, settings.any_body, answer); };
    write_file(file, text, true);
    return [command = shell_command(settings.command), name = file.string()](int answer) {
        run_in_copy(command, name, answer);
    };
}

std::string text_of(const ChildProcess::End& end, double timeout) {
    if (end.timed_out) {
        std::string text = "it takes longer than ";
        append_number(text, timeout);
        return text + " s";
    }
    if (end.signal != 0) return "signal " + std::to_string(end.signal) + " (" + strsignal(end.signal) + ")";
    return "exit code " + std::to_string(end.exit_code);
}

}  // namespace

std::string shell_command(const std::string& command) {
    std::string text = command;
    replace_all(text, "{}", "\"$1\"");
    return text;
}

Trial::Trial(const std::string& text, const TrialSettings& settings, const std::filesystem::path& file)
    : settings_(settings), file_(file), process_(work_of(text, settings, file), settings.timeout) {}

std::vector<Failure> Trial::failures() const {
    if (!settings_.is_check()) return failures_of_command();
    const ChildProcess::End& end = process_.end();
    return end.exit_code == 0 ? from_lines(end.answer) : std::vector{Failure{text_of(end, settings_.timeout)}};
}

std::vector<Failure> Trial::failures_of_command() const {
    const ChildProcess::End& end = process_.end();
    if (end.exit_code == 0) return {};
    std::string text = text_of(end, settings_.timeout);
    if (settings_.same_output) {
        std::string line = end.answer.substr(0, end.answer.find('\n'));
        replace_all(line, file_.string(), "{}");
        text += ": " + line;
    }
    return {Failure{text}};
}

std::vector<Failure> run_trial(const std::string& text, const TrialSettings& settings,
                               const std::filesystem::path& file) {
    Trial trial(text, settings, file);
    while (!trial.has_ended() && !is_interrupted()) wait_briefly();
    return is_interrupted() ? std::vector<Failure>{} : trial.failures();
}

}  // namespace tumble::tools
