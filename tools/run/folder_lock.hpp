// Keeps the folder of a run for one process.
#pragma once

#include <filesystem>

namespace tumble::tools {

// A lock on a folder (flock), which ends with the object or the process. On a file system that cannot lock folders it
// has no effect.
class FolderLock {
public:
    // Creates the folder if it is missing. Throws FileError, also if another process holds the lock: the message names
    // that process.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

}  // namespace tumble::tools
