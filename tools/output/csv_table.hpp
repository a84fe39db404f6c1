// A CSV table of any columns, which its first line names, read line by line. Lines end with LF or CR LF.
#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace io {
class LineReader;
}

namespace tumble::tools {

// The fields of a line as in RFC 4180; nothing if a quote is not closed, as in a field with a line break.
std::optional<std::vector<std::string>> cells_of(std::string line);

class CsvTable {
public:
    // Reads the first line of a file or of standard input. All functions throw FileError, or InputError that names the
    // file and the line.
    explicit CsvTable(const std::filesystem::path& file);
    ~CsvTable();

    const std::vector<std::string>& columns() const noexcept { return columns_; }

    // The index of a column. Throws InputError, which lists them, if there is none of this name.
    std::size_t column(const std::string& name) const;

    // Reads the next line, which must have all columns; false at the end.
    bool next();

    // Of the line that was read last.
    const std::string& cell(std::size_t column) const { return cells_.at(column); }

    // Throws InputError that names the file and the line.
    [[noreturn]] void fail(const std::string& message) const;

private:
    // The fields of the next line; nothing at the end.
    std::optional<std::vector<std::string>> read_line();

    std::string name_;
    std::unique_ptr<std::istream> stream_;
    std::unique_ptr<io::LineReader> lines_;
    std::vector<std::string> columns_, cells_;
};

}  // namespace tumble::tools
