// A file that is there as a whole or not at all: written under a temporary name beside the final one, and renamed once
// every byte is known to be on its way to the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tumble::tools {

// Throws FileError if something is there already and `force` is not given.
void refuse_to_overwrite(const std::filesystem::path& file, bool force);

// Creates the folders above the file. Throws FileError.
void create_folder_of(const std::filesystem::path& file);

class OutputFile {
public:
    // Creates the folders above and the temporary file. Throws FileError.
    OutputFile(std::filesystem::path file, bool force);
    ~OutputFile();  // removes the temporary file if commit() was not reached
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }

    // Appends; throws FileError, for instance on a full disk.
    void write(std::string_view text);

    // Writes what is buffered, closes, checks the size, renames. Returns the number of bytes. Throws FileError.
    std::uint64_t commit();

private:
    void flush();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    std::string buffer_;
};

}  // namespace tumble::tools
