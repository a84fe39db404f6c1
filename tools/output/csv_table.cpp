#include "tools/output/csv_table.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "tools/output/csv_library.hpp"
#include "tools/output/standard_input.hpp"
#include "tumble/file.hpp"
#include "tumble/suggest.hpp"

namespace tumble::tools {

std::optional<std::vector<std::string>> cells_of(std::string line) {
    std::vector<std::string> cells;
    try {
        for (char* begin = line.data(); begin != nullptr;) {
            char* end = begin + (CsvQuotes::find_next_column_end(begin) - begin);
            char* const rest = *end == '\0' ? nullptr : end + 1;
            CsvQuotes::unescape(begin, end);
            cells.emplace_back(begin, end);
            begin = rest;
        }
    } catch (const io::error::escaped_string_not_closed&) {
        return std::nullopt;
    }
    return cells;
}

CsvTable::CsvTable(const std::filesystem::path& file)
    : name_(file.string()), stream_(open_input(file)), lines_(std::make_unique<io::LineReader>(name_, *stream_)) {
    std::optional<std::vector<std::string>> columns = read_line();
    if (!columns) fail("has no line of columns");
    columns_ = std::move(*columns);
}

CsvTable::~CsvTable() = default;

std::optional<std::vector<std::string>> CsvTable::read_line() {
    const char* const line = with_input_errors(
        name_, [&] { return lines_->get_file_line(); }, [&] { return lines_->next_line(); });
    if (line == nullptr && stream_->bad()) throw FileError(name_, "cannot be read");
    if (line == nullptr) return std::nullopt;
    std::optional<std::vector<std::string>> cells = cells_of(line);
    if (!cells) fail("a quote is not closed");
    return cells;
}

bool CsvTable::next() {
    std::optional<std::vector<std::string>> cells = read_line();
    if (!cells) return false;
    cells_ = std::move(*cells);
    if (cells_.size() != columns_.size()) fail("has not all columns");
    return true;
}

std::size_t CsvTable::column(const std::string& name) const {
    const auto found = std::ranges::find(columns_, name);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    const std::vector<std::string_view> names(columns_.begin(), columns_.end());
    const std::string_view nearest = nearest_word(name, names);
    throw InputError(name_ + ": has no column '" + name + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?") +
                     "\n  its columns: " + join_words(names));
}

void CsvTable::fail(const std::string& message) const {
    throw InputError(name_ + ":" + std::to_string(std::max(lines_->get_file_line(), 1u)) + ": " + message);
}

}  // namespace tumble::tools
