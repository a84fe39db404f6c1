#include "process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace tumble::test {

namespace fs = std::filesystem;

namespace {

fs::path make_folder() {
    std::string name = (fs::temp_directory_path() / "tumble_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + name);
    return name;
}

void redirect(const fs::path& file, int flags, int descriptor) {
    const int opened = open(file.c_str(), flags, 0666);
    if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

Process::Process(const std::vector<std::string>& command, const fs::path& working_folder, const std::string& input,
                 const std::string& output)
    : folder_(make_folder()) {
    std::ofstream(folder_ / "in") << input;
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const fs::path out = output.empty() ? folder_ / "out" : fs::path(output);
    id_ = fork();
    if (id_ < 0) throw std::runtime_error("cannot start a process");
    if (id_ > 0) return;
    redirect(folder_ / "in", O_RDONLY, STDIN_FILENO);
    redirect(out, O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(folder_ / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
    if (chdir(working_folder.c_str()) == 0) execvp(arguments[0], arguments.data());
    _exit(127);
}

Process::~Process() {
    if (!waited_) {
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void Process::send_signal(int signal) const { kill(id_, signal); }

bool Process::is_running() const {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

Answer Process::wait() {
    int status = 0;
    waitpid(id_, &status, 0);
    waited_ = true;
    return {exit_code(status), read_text(folder_ / "out"), read_text(folder_ / "err")};
}

void wait_for(const fs::path& file, const Process& process) {
    for (int tries = 0; tries < 12000 && !fs::exists(file) && process.is_running(); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

Answer run(const std::vector<std::string>& command, const fs::path& working_folder) {
    return Process(command, working_folder).wait();
}

std::vector<std::string> tumble_command(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), TUMBLE_BINARY);
    return arguments;
}

Answer run_tumble(std::vector<std::string> arguments) { return run(tumble_command(std::move(arguments))); }

Folder::Folder() : path_(make_folder()) {}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::string read_text(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::size_t case_stride() {
    const char* const every = std::getenv("TUMBLE_ONE_OF");
    const std::size_t stride = every ? std::strtoull(every, nullptr, 10) : 1;
    if (stride == 0) throw std::runtime_error("TUMBLE_ONE_OF is not a positive number");
    return stride;
}

std::string small_scene() {
    return R"({
  "format": 1,
  "name": "small",
  "bodies": [
    {"name": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [20, 1]}}]},
    {"name": "ball", "position": [0, 3], "velocity": [1, 0], "shapes": [{"circle": {"radius": 0.5}}]},
    {"position": [0.2, 5], "angle": 30, "shapes": [{"box": {"size": [1, 0.5]}}]}
  ]
}
)";
}

}  // namespace tumble::test
