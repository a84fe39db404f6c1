// Reading and writing of whole files. OutputFile replaces a file only when everything is written, so that an
// interrupted or failed write leaves the old file unchanged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

// A file that cannot be opened, read or written. The message is the path and the reason.
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& path, std::string_view reason);
};

// The first bytes of a file: all of them if it has at most `limit`, else limit + 1, which shows the caller that the
// file is too long. Throws FileError.
std::string read_file(const std::filesystem::path& file,
                      std::size_t limit = std::numeric_limits<std::size_t>::max() - 1);

// Whether a path that a file in `folder` names leads out of that folder: by "..", as an absolute path, or through a
// symbolic link. A relative `named` is relative to `folder`. Files that do not exist are allowed.
bool leads_outside(const std::filesystem::path& folder, const std::filesystem::path& named);

// A file that another file names, such as the image of a scene.
struct FoundFile {
    bool is_there = false;  // something has the path, though it may be no file
    std::string fault;      // why it cannot be read, as what follows its name; empty: it can, or nothing is there
};

// Looks, and does not open: a pipe would wait for its other end.
FoundFile find_file(const std::filesystem::path& file);

// Whether there is a file. Throws FileError if something is there that is no regular file or cannot be read.
bool is_file_there(const std::filesystem::path& file);

// A file to be written. The bytes go to a temporary file in the same folder, with a name that no other thread or
// process uses, and commit() renames it. The path /dev/stdout stands for standard output: its bytes go there in order,
// without a temporary file, and an error may leave a part of them written. All functions throw FileError with the
// system's reason, such as a full disk.
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path file);
    ~OutputFile();  // without commit(): removes the temporary file
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }
    const std::filesystem::path& temporary() const noexcept { return temporary_; }  // empty for standard output

    // Appends bytes. They are buffered.
    void write(std::string_view bytes);

    // Writes the buffered bytes, so that the temporary file contains all so far. Returns their number.
    std::uint64_t save_so_far();

    // Closes the file without writing the buffered bytes, and keeps the temporary file. To be called once, last.
    void leave();

    // Counts what another process has written to temporary(), without replacing it, as the content, instead of what was
    // written here. Before commit().
    void take_from_others();

    // Appends bytes `begin` to `end` of another file. Throws FileError, also if it is shorter.
    void append_from(const std::filesystem::path& file, std::uint64_t begin, std::uint64_t end);

    // Writes the buffered bytes, closes the file, checks its size, and replaces the file at path(). Returns the size in
    // bytes. To be called once, last.
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

// A temporary file of an OutputFile. It remains if its process is killed.
struct PartialFile {
    std::filesystem::path path;
    std::filesystem::path file;  // the path that commit() would have renamed it to
    int process = 0;             // the process that made it
    bool is_open = false;        // whether that process still writes it
};

// The temporary files in a folder, but not in its folders; none if there is no such folder. A file is open if an
// OutputFile has its lock (flock). On a file system without such locks it counts as open if another process has the
// number in its name, which may be a later process of that number.
std::vector<PartialFile> find_partial_files(const std::filesystem::path& folder);

}  // namespace tumble
