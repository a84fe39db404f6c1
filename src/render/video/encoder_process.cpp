#include "render/video/encoder_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "tumble/render.hpp"

namespace tumble::render {

namespace {

constexpr std::size_t kMostMessages = 1 << 16;  // bytes of standard error that are read

std::string reason(int error) { return std::generic_category().message(error); }

void close_if_open(int& descriptor) {
    if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

// How the child starts: with these descriptors, in a process group of its own, which a terminal's Ctrl-C does not
// reach.
class SpawnSettings {
public:
    SpawnSettings(int input, int output, int messages) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        if (output >= 0)
            posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        else
            posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, messages, STDERR_FILENO);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
        posix_spawnattr_setpgroup(&attributes_, 0);
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    // 0, or the error.
    int spawn(pid_t& id, const std::vector<std::string>& command) const {
        std::vector<char*> arguments;
        for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
        arguments.push_back(nullptr);
        return posix_spawnp(&id, arguments[0], &actions_, &attributes_, arguments.data(), environ);
    }

private:
    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

}  // namespace

EncoderProcess::EncoderProcess(const std::vector<std::string>& command, int output) {
    // A socket and not a pipe: a write to a reader that has ended is then an error of the call, not a signal.
    int ends[2] = {-1, -1};
    messages_ = ::memfd_create("messages", MFD_CLOEXEC);
    int error = messages_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ? errno : 0;
    input_ = ends[1];
    if (error == 0) error = SpawnSettings(ends[0], output, messages_).spawn(id_, command);
    close_if_open(ends[0]);
    if (error == 0) return;
    id_ = -1;
    close_if_open(input_);
    close_if_open(messages_);
    if (error == ENOENT)
        throw RenderError("the program " + command.front() +
                          ", which encodes videos, is not installed (Debian: apt-get install --no-install-recommends "
                          "ffmpeg); frames and replays do not need it");
    throw RenderError("cannot start " + command.front() + ": " + reason(error));
}

EncoderProcess::~EncoderProcess() {
    if (id_ >= 0) {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    close_if_open(input_);
    close_if_open(messages_);
}

bool EncoderProcess::send(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

const EncoderProcess::End& EncoderProcess::wait() {
    close_if_open(input_);
    if (id_ < 0) return end_;  // waitpid(-1) would wait for any child of this process
    int status = 0;
    pid_t ended = -1;
    do ended = ::waitpid(id_, &status, 0);
    while (ended < 0 && errno == EINTR);
    if (ended == id_ && WIFEXITED(status)) end_.exit_code = WEXITSTATUS(status);
    if (ended == id_ && WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
    id_ = -1;
    end_.messages.resize(kMostMessages);
    const ssize_t size = ::pread(messages_, end_.messages.data(), kMostMessages, 0);
    end_.messages.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return end_;
}

}  // namespace tumble::render
