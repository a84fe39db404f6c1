// One line of JSON, then the bytes of the run.
#include "tools/run/checkpoint.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/run_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/world.hpp"

namespace tumble::tools {

namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

std::string header_of(const Checkpoint& checkpoint) {
    JsonWriter json(JsonWriter::Layout::compact);
    json.open_object().member("checkpoint", kVersion).member("settings", checkpoint.settings);
    json.key("tables").open_array();
    for (const SavedTable& table : checkpoint.tables)
        json.open_object()
            .member("kind", table.kind)
            .member("temporary", table.temporary.string())
            .member("file", table.file.string())
            .member("bytes", table.bytes)
            .close_object();
    json.close_array().member("frames", checkpoint.frames).member("frame_bytes", checkpoint.frame_bytes);
    const Camera& camera = checkpoint.camera;
    json.key("camera").open_object().member("center", camera.center).member("height", camera.height);
    json.member("index", camera.follows.index).member("generation", camera.follows.generation);
    json.member("offset", camera.offset).close_object();
    json.member("simulate", checkpoint.simulate_seconds).member("render", checkpoint.render_seconds);
    json.member("encode", checkpoint.encode_seconds).member("total", checkpoint.total_seconds);
    return json.close_object().text() + "\n";
}

DVec2 vector_of(const Json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

Checkpoint read_header(const Json& json) {
    Checkpoint checkpoint;
    if (json.at("checkpoint").get<int>() != kVersion) throw InputError("it is of another version");
    checkpoint.settings = json.at("settings").get<std::string>();
    for (const Json& table : json.at("tables"))
        checkpoint.tables.push_back({table.at("kind").get<std::string>(), table.at("temporary").get<std::string>(),
                                     table.at("file").get<std::string>(), table.at("bytes").get<std::uint64_t>()});
    checkpoint.frames = json.at("frames").get<std::uint64_t>();
    checkpoint.frame_bytes = json.at("frame_bytes").get<std::uint64_t>();
    const Json& camera = json.at("camera");
    checkpoint.camera = {vector_of(camera.at("center")), camera.at("height").get<double>()};
    checkpoint.camera.follows = {camera.at("index").get<std::uint32_t>(), camera.at("generation").get<std::uint32_t>()};
    checkpoint.camera.offset = vector_of(camera.at("offset"));
    checkpoint.simulate_seconds = json.at("simulate").get<double>();
    checkpoint.render_seconds = json.at("render").get<double>();
    checkpoint.encode_seconds = json.at("encode").get<double>();
    checkpoint.total_seconds = json.at("total").get<double>();
    return checkpoint;
}

// The name of a temporary table while a run continues it.
std::filesystem::path kept_file(const SavedTable& table) {
    std::filesystem::path name = table.file;
    return name += ".earlier";
}

}  // namespace

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
    OutputFile file(checkpoint_file(folder));
    file.write(header_of(checkpoint));
    file.write({reinterpret_cast<const char*>(checkpoint.run.data()), checkpoint.run.size()});
    file.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& folder, const std::string& settings) {
    const std::filesystem::path file = checkpoint_file(folder);
    if (!std::filesystem::exists(file))
        throw FileError(folder, "contains no checkpoint; --checkpoint makes a run write them");
    const std::string text = read_file(file);
    const std::size_t line = std::min(text.find('\n'), text.size() - (text.empty() ? 0 : 1));
    Checkpoint checkpoint;
    try {
        checkpoint = read_header(Json::parse(std::string_view(text).substr(0, line)));
        const auto run = std::as_bytes(std::span(text).subspan(line + 1));
        checkpoint.run.assign(run.begin(), run.end());
    } catch (const std::exception& error) {
        throw InputError(file.string() + ": is not a checkpoint of this version: " + error.what());
    }
    if (checkpoint.settings != settings)
        throw CLI::ValidationError(
            "--resume", "the run was begun with other options: " + checkpoint.settings + "; now they are: " + settings);
    return checkpoint;
}

std::string settings_of(const RunOptions& options) {
    std::string text = "no frames";
    if (!options.no_frames) {
        append_number(text = "frames ", options.frames_per_second);
        text += "/s " + std::to_string(options.size.width) + "x" + std::to_string(options.size.height);
        for (const OverlayPart& part : kOverlayParts)
            if (options.overlay.*part.member) text += " " + std::string(part.name);
    }
    for (const auto& [name, file] :
         {std::pair("contacts", &options.contacts), {"trajectory", &options.trajectory}, {"hashes", &options.hashes}})
        if (!file->empty()) text += std::string(", ") + name + " " + file->string();
    return text;
}

SceneRun load_run(const Scene& scene, const Checkpoint& saved, const std::filesystem::path& folder) {
    try {
        return SceneRun::load(scene, saved.run);
    } catch (const SnapshotError& error) {
        throw InputError(checkpoint_file(folder).string() + ": " + error.what());
    }
}

void keep_tables(const Checkpoint& saved, const std::filesystem::path& folder) {
    for (const SavedTable& table : saved.tables)
        if (std::filesystem::exists(table.temporary)) std::filesystem::rename(table.temporary, kept_file(table));
    remove_partial_files(folder);
    for (const SavedTable& table : saved.tables) remove_dead_parts_of(table.file);
}

void continue_table(const Checkpoint& saved, const std::string& kind, OutputFile& file) {
    const auto table = std::ranges::find(saved.tables, kind, &SavedTable::kind);
    if (table == saved.tables.end()) throw FileError(file.path(), "the checkpoint does not have this table");
    const bool is_kept = std::filesystem::exists(kept_file(*table));
    file.append_from(is_kept ? kept_file(*table) : table->file, file.save_so_far(), table->bytes);
}

void remove_kept_tables(const Checkpoint& saved) {
    for (const SavedTable& table : saved.tables) std::filesystem::remove(kept_file(table));
}

}  // namespace tumble::tools
