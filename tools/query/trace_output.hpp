// Writes the iterations of a distance query as a picture or as JSON, depending on the extension of the file.
#pragma once

#include <filesystem>

#include "tools/query/distance_query.hpp"

namespace tumble::tools {

// Whether the extension is .png, .svg or .json.
bool is_trace_file(const std::filesystem::path& file);

// Throws FileError, or RenderError for a PNG.
void write_trace(const std::filesystem::path& file, const DistanceQuery& query, SubAlgorithm sub_algorithm, bool force);

}  // namespace tumble::tools
