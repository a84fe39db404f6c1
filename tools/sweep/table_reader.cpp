#include "tools/sweep/table_reader.hpp"

#include <charconv>

namespace tumble::tools {

TableReader::TableReader(const std::filesystem::path& folder, const sweep::SweepHeader& header)
    : table_(sweep::table_file(folder)) {
    const std::string expected = header.columns.substr(0, header.columns.find('\n'));
    if (cells_of(expected) != columns()) fail("the columns are not those of the manifest");
}

std::vector<std::size_t> TableReader::columns_between(const std::string& first, const std::string& last) const {
    std::vector<std::size_t> between;
    for (std::size_t index = column(first) + 1; index < column(last); ++index) between.push_back(index);
    return between;
}

bool TableReader::next() {
    if (!table_.next()) return false;
    const std::string& text = cell(0);
    if (std::from_chars(text.data(), text.data() + text.size(), run_).ec != std::errc()) fail("has no number of a run");
    return true;
}

}  // namespace tumble::tools
