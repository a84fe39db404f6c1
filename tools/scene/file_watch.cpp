#include "tools/scene/file_watch.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include "tumble/file.hpp"

#ifdef __linux__
#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>
#endif

namespace tumble::tools {

#ifdef __linux__

namespace {

// A file is complete when it is closed or renamed, not when its first bytes are written.
constexpr std::uint32_t kSaves = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

}  // namespace

FileWatch::FileWatch() : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (queue_ < 0) throw FileError("inotify", std::strerror(errno));
}

FileWatch::~FileWatch() { close(queue_); }

void FileWatch::add(const std::filesystem::path& file) {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    if (folders_.contains(folder)) return;
    if (inotify_add_watch(queue_, folder.c_str(), kSaves) < 0) throw FileError(folder, std::strerror(errno));
    folders_.insert(folder);
}

bool FileWatch::wait(std::chrono::milliseconds longest) {
    pollfd ready{queue_, POLLIN, 0};
    if (poll(&ready, 1, static_cast<int>(longest.count())) <= 0) return false;
    std::array<char, 4096> events;
    while (read(queue_, events.data(), events.size()) > 0) continue;
    return true;
}

#else

FileWatch::FileWatch() { throw FileError("watch", "needs inotify of Linux, which this system does not have"); }
FileWatch::~FileWatch() = default;
void FileWatch::add(const std::filesystem::path&) {}
bool FileWatch::wait(std::chrono::milliseconds) { return false; }

#endif

}  // namespace tumble::tools
