// A table of a run that a later run can continue: an output file with a hash of its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "tumble/file.hpp"

namespace tumble::tools {

// The first bytes of a file: their number, and their XXH64.
struct TableBytes {
    std::uint64_t count = 0;
    std::uint64_t hash = 0;
};

class TableFile {
public:
    // As open_output().
    TableFile(const std::filesystem::path& file, bool force);
    ~TableFile();

    const std::filesystem::path& path() const noexcept { return file_.path(); }
    const std::filesystem::path& temporary() const noexcept { return file_.temporary(); }

    // As those of OutputFile.
    void write(std::string_view text);
    void leave() { file_.leave(); }
    std::uint64_t commit() { return file_.commit(); }

    // Writes the buffered bytes, and describes all bytes so far.
    TableBytes save_so_far();

    // Appends the rest of an earlier table, of which this one has the beginning: the bytes from the end of this table
    // up to `expected.count`. False, with nothing appended, if the first bytes of the earlier table are not the
    // expected ones. Throws FileError if it cannot be read.
    bool continue_from(const std::filesystem::path& earlier, const TableBytes& expected);

private:
    class Hash;

    OutputFile file_;
    std::unique_ptr<Hash> hash_;
};

}  // namespace tumble::tools
