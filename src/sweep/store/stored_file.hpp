// A file of a sweep while it is written, with its checksum.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "sweep/store/manifest.hpp"

namespace tumble::sweep {

// Like OutputFile: the file is there when commit() returns, or not at all.
class StoredFileWriter {
public:
    StoredFileWriter(const std::filesystem::path& folder, const std::string& name);
    ~StoredFileWriter();

    void write(std::string_view bytes);
    std::uint64_t size() const noexcept { return size_; }
    // The bytes are on the disk when it gets its name. The name is when make_durable() of the folder returns.
    StoredFile commit();

private:
    struct Impl;

    std::unique_ptr<Impl> impl_;
    std::uint64_t size_ = 0;
};

// The size and the checksum of a file, read in blocks. Throws FileError, also for one that is not regular: a pipe or a
// device may have no end.
StoredFile read_stored_file(const std::filesystem::path& folder, const std::string& name);

}  // namespace tumble::sweep
