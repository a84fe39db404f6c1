#include "tools/query/trace_output.hpp"

#include <string>

#include "tools/cli/output_path.hpp"
#include "tumble/drawing.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

void write_step(JsonWriter& json, const TraceStep& step) {
    json.open_object().key("simplex").open_array();
    for (std::size_t i = 0; i < step.count; ++i) write_pair(json, step.simplex[i]);
    json.close_array().key("vertices").open_array();
    for (std::size_t i = 0; i < step.count; ++i) json.value(step.vertices[i]);
    json.close_array().member("closest", step.closest).member("direction", step.direction);
    write_pair(json.key("support"), step.support);
    json.member("support_vertex", step.support_vertex)
        .member("lower", step.lower)
        .member("upper", step.upper)
        .close_object();
}

std::string trace_json(const DistanceQuery& query, const DistanceTrace& trace) {
    JsonWriter json;
    json.open_object().key("steps").open_array();
    for (const TraceStep& step : trace.steps) write_step(json, step);
    write_answer(json.close_array().key("result"), query, trace.result);
    return json.close_object().text() + "\n";
}

}  // namespace

std::optional<TraceFormat> trace_format_of(const std::filesystem::path& file) {
    const std::filesystem::path extension = file.extension();
    if (extension == ".png") return TraceFormat::png;
    if (extension == ".svg") return TraceFormat::svg;
    if (extension == ".json") return TraceFormat::json;
    return std::nullopt;
}

void write_trace(const std::filesystem::path& file, TraceFormat format, const DistanceQuery& query,
                 SubAlgorithm sub_algorithm, RenderBackend renderer, bool force) {
    const DistanceTrace trace = trace_distance(query.a, query.a_pose, query.b, query.b_pose, sub_algorithm);
    if (format == TraceFormat::json) return write_file(file, trace_json(query, trace), force);
    const Drawing drawing = draw_trace(query.a, query.a_pose, query.b, query.b_pose, trace);
    if (format == TraceFormat::svg) return write_file(file, to_svg(drawing), force);
    refuse_to_overwrite(file, force);
    create_folder_of(file);
    write_png(draw_image(drawing, renderer), file);
}

}  // namespace tumble::tools
