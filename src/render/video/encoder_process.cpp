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

constexpr std::size_t kMostWords = 1 << 16;  // bytes of standard error that are read

std::string reason(int error) { return std::generic_category().message(error); }

void close_if_open(int& descriptor) {
    if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

// How the child starts: with these descriptors, in a process group of its own, which a terminal's Ctrl-C does not
// reach.
class SpawnSettings {
public:
    SpawnSettings(int input, int words) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, words, STDERR_FILENO);
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
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        return posix_spawnp(&id, words[0], &actions_, &attributes_, words.data(), environ);
    }

private:
    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

}  // namespace

EncoderProcess::EncoderProcess(const std::vector<std::string>& command) {
    // A socket and not a pipe: a write to a reader that has ended is then an error of the call, not a signal.
    int ends[2] = {-1, -1};
    words_ = ::memfd_create("words", MFD_CLOEXEC);
    int error = words_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ? errno : 0;
    input_ = ends[1];
    if (error == 0) error = SpawnSettings(ends[0], words_).spawn(id_, command);
    close_if_open(ends[0]);
    if (error == 0) return;
    id_ = -1;
    close_if_open(input_);
    close_if_open(words_);
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
    close_if_open(words_);
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

EncoderProcess::End EncoderProcess::wait() {
    close_if_open(input_);
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    End end;
    if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    end.words.resize(kMostWords);
    const ssize_t size = ::pread(words_, end.words.data(), kMostWords, 0);
    end.words.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return end;
}

}  // namespace tumble::render
