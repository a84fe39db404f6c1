// Writes the iterations of a distance query as a picture or as JSON.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/query/distance_query.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

enum class TraceFormat { png, svg, json };

// By the extension of the file: .png, .svg or .json. Nothing for others.
std::optional<TraceFormat> trace_format_of(const std::filesystem::path& file);

// Throws FileError, or RenderError for a PNG.
void write_trace(const std::filesystem::path& file, TraceFormat format, const DistanceQuery& query,
                 SubAlgorithm sub_algorithm, RenderBackend renderer, bool force);

}  // namespace tumble::tools
