#include "tools/shrink/child_process.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "tools/cli/interrupt.hpp"

namespace tumble::tools {

namespace {

// In the copy, before its work: nothing of the terminal, no core dumps, and an end with this process.
void prepare_copy() {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
}

std::string read_from_start(int descriptor) {
    std::string bytes;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t size = ::pread(descriptor, buffer.data(), buffer.size(), static_cast<off_t>(bytes.size()));
        if (size <= 0 || bytes.size() > (1u << 20)) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(size));
    }
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(int answer)>& work, double timeout) : timeout_(timeout) {
    answer_ = ::memfd_create("answer", MFD_CLOEXEC);
    id_ = answer_ < 0 ? -1 : ::fork();
    if (id_ < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
    if (id_ > 0) {
        ::setpgid(id_, id_);  // by both, because either may be the first to continue
        return;
    }
    prepare_copy();
    try {
        work(answer_);
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

ChildProcess::~ChildProcess() {
    if (id_ > 0) {
        ::kill(-id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    if (answer_ >= 0) ::close(answer_);
}

bool ChildProcess::has_ended() {
    if (id_ < 0) return true;
    int status = 0;
    const pid_t ended = ::waitpid(id_, &status, WNOHANG);
    if (ended == id_) {
        take_end(status);
    } else if (watch_.seconds() > timeout_) {
        ::kill(-id_, SIGKILL);
        ::waitpid(id_, &status, 0);
        take_end(status);
        end_.timed_out = true;
    }
    return id_ < 0;
}

const ChildProcess::End& ChildProcess::wait() {
    while (!has_ended() && !is_interrupted()) wait_briefly();
    return end_;
}

void ChildProcess::take_end(int status) {
    ::kill(-id_, SIGKILL);  // what it has started and left behind
    id_ = -1;
    if (WIFEXITED(status)) end_.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
    end_.answer = read_from_start(answer_);
}

void write_all(int descriptor, const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t size = ::write(descriptor, bytes.data() + at, bytes.size() - at);
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) return;
        at += static_cast<std::size_t>(size);
    }
}

void wait_briefly() { std::this_thread::sleep_for(std::chrono::microseconds(200)); }

}  // namespace tumble::tools
