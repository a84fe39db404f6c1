// A folder among the temporary files of the system (TMPDIR), which is removed with all in it.
#pragma once

#include <filesystem>
#include <string>

namespace tumble::tools {

class TemporaryFolder {
public:
    // Its name is "tumble-PURPOSE-" and six letters that no other folder has. Throws FileError.
    explicit TemporaryFolder(const std::string& purpose);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace tumble::tools
