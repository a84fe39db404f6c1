#include "tools/bench/v3_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <thread>

#include "tools/output/input_error.hpp"
#include "tools/output/temporary_folder.hpp"

namespace tumble::tools {

namespace {

constexpr std::size_t kMostOutput = 1 << 20;  // bytes that are read

// Reads until the other end is closed. What is longer than kMostOutput is read and dropped.
std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer{};
    while (true) {
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        if (text.size() < kMostOutput) text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

// The number after the first `label` in a text; 0 if there is none.
double number_after(const std::string& text, const std::string& label) {
    const std::size_t at = text.find(label);
    return at == std::string::npos ? 0.0 : std::strtod(text.c_str() + at + label.size(), nullptr);
}

}  // namespace

V3Program::V3Program(const std::filesystem::path& program) : program_(std::filesystem::absolute(program)) {
    std::istringstream lines(output_of({"-l"}));
    for (std::string line; std::getline(lines, line);) {  // "   0  compounds"
        std::istringstream words(line);
        int number = 0;
        std::string name;
        if (words >> number >> name) scenes_.push_back(name);
    }
    if (scenes_.empty()) throw InputError(program.string() + " lists no scenes: it is not the benchmark of Box2D v3");
}

bool V3Program::has(const std::string& scene) const { return std::ranges::find(scenes_, scene) != scenes_.end(); }

V3Program::Run V3Program::run(const std::string& scene, int threads) const {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    const std::string count = std::to_string(threads > 0 ? static_cast<unsigned>(threads) : processors);
    const std::string text = output_of({"-t=" + count, "-w=" + count, "-r=1", "-b=" + scene});
    // "benchmark: rain, steps = 1000" and "run 0 : 1234.5 (ms)", the time of all steps.
    const Run run{static_cast<int>(number_after(text, "steps = ")), number_after(text, "run 0 : ")};
    if (run.steps <= 0 || !(run.ms > 0.0))
        throw InputError(program_.string() + " printed no time of the scene " + scene + ":\n" + text);
    return {run.steps, run.ms / run.steps};
}

// Runs the program in a folder of its own, as it writes files where it starts.
std::string V3Program::output_of(const std::vector<std::string>& arguments) const {
    const TemporaryFolder folder("bench");
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw InputError("no pipe for " + program_.string() + ": " + std::generic_category().message(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), program_.string());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int error = ::posix_spawn(&child, program_.c_str(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    std::string text = error == 0 ? read_all(ends[0]) : "";
    ::close(ends[0]);
    if (error != 0)
        throw InputError("cannot start " + program_.string() + ": " + std::generic_category().message(error));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw InputError(program_.string() + " " + arguments.back() + " failed");
    return text;
}

}  // namespace tumble::tools
