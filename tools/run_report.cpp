#include "run_report.hpp"

#include <cstdio>

#include "json_writer.hpp"
#include "version.hpp"

namespace tumble::tools {

namespace {

std::string format(const char* pattern, double number) {
    char text[64];
    std::snprintf(text, sizeof text, pattern, number);
    return text;
}

void append_line(std::string& text, const std::string& label, const std::string& content) {
    text += "  " + label + std::string(label.size() < 12 ? 12 - label.size() : 1, ' ') + content + "\n";
}

std::string describe(const WrittenFiles& files) {
    const std::string size = format("%.1f MB", static_cast<double>(files.bytes) / 1e6);
    if (files.count == 1) return files.path.string() + ", " + size;
    return files.path.string() + " and on, " + std::to_string(files.count) + " files, " + size;
}

}  // namespace

std::string to_json(const RunReport& report) {
    JsonWriter json;
    json.open_object()
        .member("version", version())
        .member("scene", report.scene_name)
        .member("scene_hash", to_hex(report.scene_hash))
        .member("seed", report.seed)
        .member("dt", report.dt)
        .member("steps", report.steps);
    json.key("wall_s")
        .open_object()
        .member("simulate", report.simulate_seconds)
        .member("render", report.render_seconds)
        .member("encode", report.encode_seconds)
        .member("total", report.total_seconds)
        .close_object();
    json.member("bodies", report.bodies)
        .member("contacts", report.contacts)
        .member("state_hash", to_hex(report.state_hash));
    json.key("files").open_array();
    for (const WrittenFiles& files : report.files)
        json.open_object()
            .member("kind", files.kind)
            .member("path", files.path.string())
            .member("count", files.count)
            .member("bytes", files.bytes)
            .close_object();
    json.close_array().member("complete", report.complete).close_object();
    return json.text() + "\n";
}

std::string to_text(const RunReport& report) {
    std::string text = report.scene_name + ": " + std::to_string(report.steps) + " steps of " +
                       format("%.3g ms", 1e3 * report.dt) + ", " + std::to_string(report.bodies) + " bodies, " +
                       std::to_string(report.contacts) + " contacts at the end" +
                       (report.complete ? "" : ", not complete") + "\n";
    for (const WrittenFiles& files : report.files) append_line(text, files.kind, describe(files));
    append_line(text, "state hash", to_hex(report.state_hash));
    append_line(text, "time",
                format("%.2f s: ", report.total_seconds) + format("simulate %.2f, ", report.simulate_seconds) +
                    format("render %.2f, ", report.render_seconds) +
                    format("encode %.2f on threads beside", report.encode_seconds));
    return text;
}

}  // namespace tumble::tools
