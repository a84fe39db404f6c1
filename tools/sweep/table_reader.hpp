// Reads the table of a complete sweep, line by line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/store/manifest.hpp"
#include "tools/output/csv_table.hpp"

namespace tumble::tools {

class TableReader {
public:
    // Throws FileError if there is no table, and InputError if its columns are not those of a sweep.
    TableReader(const std::filesystem::path& folder, const sweep::SweepHeader& header);

    const std::vector<std::string>& columns() const noexcept { return table_.columns(); }

    // The index of a column. Throws InputError, which lists them, if there is none of this name.
    std::size_t column(const std::string& name) const { return table_.column(name); }

    // The columns between two others: the parameters are between seed and outcome.
    std::vector<std::size_t> columns_between(const std::string& first, const std::string& last) const;

    // Reads the next line; false at the end. Throws InputError for a line that has not all columns.
    bool next();

    // Of the line that was read last.
    std::uint64_t run() const noexcept { return run_; }
    const std::string& cell(std::size_t column) const { return table_.cell(column); }

    // Throws InputError that names the file and the line.
    [[noreturn]] void fail(const std::string& message) const { table_.fail(message); }

private:
    CsvTable table_;
    std::uint64_t run_ = 0;
};

}  // namespace tumble::tools
