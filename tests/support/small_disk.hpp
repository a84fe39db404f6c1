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
    // Creates the folder. Where this user may not mount, the disk is not mounted, and a message of the test says so.
    SmallDisk(std::filesystem::path folder, int kilobytes) : folder_(std::move(folder)) {
        std::filesystem::create_directories(folder_);
        const std::string size = "size=" + std::to_string(kilobytes) + "k";
        mounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, size.c_str()) == 0;
        if (!mounted_) MESSAGE("not tested: this user may not mount a small file system: " << std::strerror(errno));
    }
    ~SmallDisk() {
        if (mounted_) umount(folder_.c_str());
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool is_mounted() const { return mounted_; }
    void make_read_only() const { mount(nullptr, folder_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr); }

private:
    std::filesystem::path folder_;
    bool mounted_ = false;
};

}  // namespace tumble::test
