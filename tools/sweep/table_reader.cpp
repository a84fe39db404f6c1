#include "tools/sweep/table_reader.hpp"

#include <charconv>

#include "tools/output/csv_columns.hpp"
#include "tools/output/input_error.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

TableReader::TableReader(const std::filesystem::path& folder, const sweep::SweepHeader& header)
    : file_(sweep::table_file(folder)), stream_(file_) {
    std::string line;
    if (!std::getline(stream_, line)) throw FileError(file_, "cannot be read");
    columns_ = cells_of(line);
    if (line + "\n" != header.columns) fail("the columns are not those of the manifest");
}

std::size_t TableReader::column(const std::string& name) const { return column_of(columns_, name, file_); }

std::vector<std::size_t> TableReader::columns_between(const std::string& first, const std::string& last) const {
    std::vector<std::size_t> between;
    for (std::size_t index = column(first) + 1; index < column(last); ++index) between.push_back(index);
    return between;
}

bool TableReader::next() {
    std::string line;
    if (!std::getline(stream_, line)) return false;
    ++line_;
    cells_ = cells_of(line);
    if (cells_.size() != columns_.size()) fail("has not all columns");
    const std::string& text = cells_.front();
    if (std::from_chars(text.data(), text.data() + text.size(), run_).ec != std::errc()) fail("has no number of a run");
    return true;
}

void TableReader::fail(const std::string& message) const {
    throw InputError(file_.string() + ":" + std::to_string(line_) + ": " + message);
}

}  // namespace tumble::tools
