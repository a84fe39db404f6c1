#include "tools/run/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

// "process 1234 (tumble run pile.json)": the process that writes files into the folder.
std::string holder_of(const fs::path& folder) {
    const std::vector<PartialFile> files = find_partial_files(folder);
    const auto found = std::ranges::find(files, true, &PartialFile::is_open);
    if (found == files.end()) return "another process";
    std::string text = "process " + std::to_string(found->process);
    try {
        std::string command = read_file("/proc/" + std::to_string(found->process) + "/cmdline", 200);
        while (command.ends_with('\0')) command.pop_back();
        std::ranges::replace(command, '\0', ' ');
        return text + " (" + command + ")";
    } catch (const FileError&) {
        return text;  // it has just ended, or belongs to another user
    }
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder: " + error.message());
    descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw FileError(folder, holder_of(folder) +
                                " writes its results into this folder; choose another with -o, or wait for its end");
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace tumble::tools
