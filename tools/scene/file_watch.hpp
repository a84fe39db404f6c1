// Waits until something is saved in the folders of given files.
#pragma once

#include <chrono>
#include <filesystem>
#include <set>

namespace tumble::tools {

// Uses inotify, so that it does no work while nothing is saved. Editors that write a new file and rename it over the
// old one are seen too, because folders are watched and not files.
class FileWatch {
public:
    FileWatch();  // throws FileError, on systems without inotify always
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    // Also watches the folder of the file. Throws FileError if it cannot be watched.
    void add(const std::filesystem::path& file);

    // Whether a file in one of the folders has been written, renamed or removed since the last call. Waits for that at
    // most this long, or until a signal arrives.
    bool wait(std::chrono::milliseconds longest);

private:
    int queue_ = -1;
    std::set<std::filesystem::path> folders_;
};

}  // namespace tumble::tools
