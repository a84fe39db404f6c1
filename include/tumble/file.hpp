// Files that are whole or not there. What the library and its command line write (scenes, pictures, tables) goes
// through OutputFile, so that an interrupted or failed write leaves what stood there before.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble {

// A file that cannot be opened, read or written: path and reason.
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& path, std::string_view reason);
};

// At most `limit` + 1 bytes of a file, so that the caller sees that there are more; by default all. Throws FileError.
std::string read_file(const std::filesystem::path& file,
                      std::size_t limit = std::numeric_limits<std::size_t>::max() - 1);

// Writes under a temporary name in the same folder (one that no other thread or process uses), and takes the file's
// name at commit(). All functions throw FileError with the system's reason, for instance on a full disk.
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path file);
    ~OutputFile();  // removes the temporary file if commit() was not reached
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }

    void write(std::string_view bytes);  // appends; buffered

    // Writes what is buffered, closes, checks the size, and replaces a file of that name. Returns the number of bytes.
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

}  // namespace tumble
