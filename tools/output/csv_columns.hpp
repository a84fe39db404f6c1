// The columns of a CSV table, from its first line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::tools {

// The fields of a line as in RFC 4180. A field with a line break is not supported.
std::vector<std::string> cells_of(const std::string& line);

// The index of a column. Throws InputError, which lists the columns that `file` has.
std::size_t column_of(const std::vector<std::string>& columns, const std::string& name,
                      const std::filesystem::path& file);

}  // namespace tumble::tools
