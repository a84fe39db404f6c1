#include "tools/run/run_report.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "tools/machine/build_info.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/step_stages.hpp"

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

void add_counters(JsonWriter& json, const RunReport& report) {
    const StepCounters& last = report.counters;
    json.key("counters")
        .open_object()
        .member("bodies", last.bodies)
        .member("awake_bodies", last.awake_bodies)
        .member("islands", report.islands)
        .member("sleeping_islands", last.sleeping_islands)
        .member("contacts", last.contacts)
        .member("contact_points", last.contact_points)
        .member("joints", last.joints)
        .member("colors", last.colors)
        .member("pairs", last.pairs)
        .member("collided", last.collided)
        .member("gjk_iterations", last.gjk_iterations)
        .close_object();
    json.key("ms_per_step").open_object();
    const double steps = static_cast<double>(std::max<std::uint64_t>(report.timed_steps, 1));
    for (const StepStage& stage : kStepStages) json.member(stage.name, report.stages.*stage.ms / steps);
    json.close_object();
    const WorldMemory& memory = report.memory;
    json.key("memory_bytes")
        .open_object()
        .member("bodies", memory.bodies)
        .member("shapes", memory.shapes)
        .member("joints", memory.joints)
        .member("broad_phase", memory.broad_phase)
        .member("contacts", memory.contacts)
        .member("solver", memory.solver)
        .member("other", memory.other)
        .member("total", memory.total())
        .close_object();
}

std::string describe(const WrittenFiles& files) {
    const double bytes = static_cast<double>(files.bytes);
    const std::string size = bytes < 1e5 ? format("%.1f kB", bytes / 1e3) : format("%.1f MB", bytes / 1e6);
    if (files.count == 1) return files.path.string() + ", " + size;
    return files.path.string() + " and so on, " + counted(files.count, "file") + ", " + size;
}

}  // namespace

void add_times(StageTimes& sum, const StageTimes& step) {
    for (const StepStage& stage : kStepStages) sum.*stage.ms += step.*stage.ms;
}

std::string to_json(const RunReport& report) {
    JsonWriter json;
    json.open_object()
        .member("version", version())
        .member("scene", report.scene_name)
        .member("scene_hash", to_hex(report.scene_hash))
        .member("seed", report.seed);
    json.key("draws").open_object();
    for (const SceneDraw& draw : report.draws) json.member(draw.key, draw.value);
    json.close_object();
    json.member("dt", report.dt).member("steps", report.steps);
    json.key("wall_s")
        .open_object()
        .member("simulate", report.simulate_seconds)
        .member("render", report.render_seconds)
        .member("encode", report.encode_seconds)
        .member("total", report.total_seconds)
        .close_object();
    json.member("bodies", report.bodies)
        .member("contacts", report.counters.contacts)
        .member("state_hash", to_hex(report.state_hash));
    add_counters(json, report);
    json.key("files").open_array();
    for (const WrittenFiles& files : report.files)
        json.open_object()
            .member("kind", files.kind)
            .member("path", files.path.string())
            .member("count", files.count)
            .member("bytes", files.bytes)
            .close_object();
    json.close_array().key("view");
    write_views(json, report.frame_size, report.views);
    if (report.health) write_health(json.key("health"), *report.health);
    json.member("complete", report.complete).close_object();
    return json.text() + "\n";
}

std::string to_text(const RunReport& report) {
    std::string text = report.scene_name + ": " + counted(report.steps, "step") + " of " +
                       format("%.3g ms", 1e3 * report.dt) + ", " + counted(report.bodies, "body") + ", " +
                       counted(report.counters.contacts, "contact") + " at the end" +
                       (report.complete ? "" : ", interrupted before the end") + "\n";
    for (const WrittenFiles& files : report.files) append_line(text, files.kind, describe(files));
    if (report.health) append_line(text, "health", counted(report.health->findings.size(), "finding"));
    append_line(text, "state hash", to_hex(report.state_hash));
    append_line(text, "time",
                format("%.2f s: ", report.total_seconds) + format("simulate %.2f, ", report.simulate_seconds) +
                    format("render %.2f, ", report.render_seconds) +
                    format("encode %.2f (summed over parallel threads)", report.encode_seconds));
    return text;
}

}  // namespace tumble::tools
