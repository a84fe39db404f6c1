#include "tools/output/csv_columns.hpp"

#include <algorithm>
#include <string_view>

#include "tools/output/input_error.hpp"
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

std::size_t column_of(const std::vector<std::string>& columns, const std::string& name,
                      const std::filesystem::path& file) {
    const auto found = std::ranges::find(columns, name);
    if (found != columns.end()) return static_cast<std::size_t>(found - columns.begin());
    const std::vector<std::string_view> names(columns.begin(), columns.end());
    const std::string_view nearest = nearest_word(name, names);
    throw InputError(file.string() + ": has no column '" + name + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?") +
                     "\n  its columns: " + join_words(names));
}

}  // namespace tumble::tools
