// The iterations of a distance query in a file, as a picture or as JSON, by the file's extension.
#pragma once

#include <filesystem>

#include "tools/query/distance_query.hpp"

namespace tumble::tools {

// Whether the extension is one of .png, .svg, .json.
bool is_trace_file(const std::filesystem::path& file);

// Throws FileError, or RenderError for a PNG.
void write_trace(const std::filesystem::path& file, const DistanceQuery& query, SubAlgorithm sub_algorithm, bool force);

}  // namespace tumble::tools
