// A small file system, which is soon full.
#pragma once

#include <doctest/doctest.h>
#include <sys/mount.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

namespace tumble::test {

class SmallDisk {
public:
    // Creates the folder. The test fails where this user may not mount.
    SmallDisk(std::filesystem::path folder, int kilobytes) : folder_(std::move(folder)) {
        std::filesystem::create_directories(folder_);
        const std::string size = "size=" + std::to_string(kilobytes) + "k";
        if (mount("tmpfs", folder_.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, size.c_str()) != 0)
            FAIL("this user may not mount a small file system: "
                 << std::strerror(errno) << "; run the test as root, or with unshare --map-root-user --mount");
    }
    ~SmallDisk() { umount(folder_.c_str()); }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    void make_read_only() const { mount(nullptr, folder_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr); }

private:
    std::filesystem::path folder_;
};

}  // namespace tumble::test
