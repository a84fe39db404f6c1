// Reads distance queries and writes their results.
#pragma once

#include <string>
#include <string_view>

#include "tools/output/json_writer.hpp"
#include "tumble/distance.hpp"

namespace tumble::tools {

// A polygon is the exact hull of its vertices (make_exact_polygon()).
struct DistanceQuery {
    Shape a, b;
    Pose a_pose, b_pose;
};

// Reads a line of `distance --stdin`: {"a": SHAPE, "b": SHAPE, "a_pose": POSE, "b_pose": POSE}. A pose may also be the
// key "pose" of its shape. Throws InputError or SceneError.
DistanceQuery parse_query_line(std::string_view line);

// The same without the fast path for plain lines (plain_query.hpp). Ten times slower; all errors come from here.
DistanceQuery parse_query_line_strictly(std::string_view line);

// Reads the two arguments of `distance A B`: each a SHAPE with an optional key "pose". Throws InputError or SceneError.
DistanceQuery parse_query_arguments(std::string_view a, std::string_view b);

// [vertex of A, vertex of B]
void write_pair(JsonWriter& json, VertexPair pair);

// Writes the result as the JSON object of the command line's contract.
void write_answer(JsonWriter& json, const DistanceQuery& query, const DistanceResult& result);

// The result as a few lines of text.
std::string answer_text(const DistanceResult& result);

}  // namespace tumble::tools
