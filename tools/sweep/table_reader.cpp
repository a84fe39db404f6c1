#include "tools/sweep/table_reader.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "tools/output/input_error.hpp"
#include "tumble/file.hpp"
#include "tumble/suggest.hpp"

namespace tumble::tools {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];  // a quote within quotes is written twice
        else if (line[i] == '"')
            is_quoted = !is_quoted;
        else if (line[i] == ',' && !is_quoted)
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    return cells;
}

TableReader::TableReader(const std::filesystem::path& folder, const sweep::SweepHeader& header)
    : file_(sweep::table_file(folder)), stream_(file_) {
    std::string line;
    if (!std::getline(stream_, line)) throw FileError(file_, "cannot be read");
    columns_ = cells_of(line);
    if (line + "\n" != header.columns) fail("the columns are not those of the manifest");
}

std::size_t TableReader::column(const std::string& name) const {
    const auto found = std::ranges::find(columns_, name);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    const std::vector<std::string_view> names(columns_.begin(), columns_.end());
    const std::string hint = suggestion(name, names);
    throw InputError(file_.string() + ": has no column '" + name + "'" + (hint.empty() ? "" : "; " + hint));
}

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
