// A file for parsers that open a path. Each has a folder of its own, removed at the end.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace tumble::fuzz {

class ScratchFile {
public:
    explicit ScratchFile(const std::string& name) {
        std::string folder = (std::filesystem::temp_directory_path() / "tumble-fuzz-XXXXXX").string();
        if (mkdtemp(folder.data()) == nullptr) std::abort();
        folder_ = folder;
        path_ = folder_ / name;
        std::filesystem::create_directories(path_.parent_path());
    }
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& write(std::string_view bytes) const {
        write_to(path_, bytes);
        return path_;
    }

    // Another file of its folder.
    std::filesystem::path write_beside(const std::string& name, std::string_view bytes) const {
        write_to(path_.parent_path() / name, bytes);
        return path_.parent_path() / name;
    }

private:
    static void write_to(const std::filesystem::path& path, std::string_view bytes) {
        std::ofstream(path, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }

    std::filesystem::path folder_, path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace tumble::fuzz
