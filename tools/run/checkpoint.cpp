// One line of JSON, then the bytes of the run.
#include "tools/run/checkpoint.hpp"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/run/run_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/world.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kVersion = 5;

void write_view_state(JsonWriter& json, const FrameOutput::State& state) {
    json.key("trails").open_array();
    for (const Trail& trail : state.trails) {
        json.open_object().member("index", trail.body.index).member("generation", trail.body.generation);
        json.member("stride", trail.stride).key("points").open_array();
        for (const DVec2 point : trail.points) json.value(point);
        json.close_array().close_object();
    }
    json.close_array().key("views").open_array();
    for (const FrameView& view : state.views)
        json.open_object()
            .member("frame", view.frame)
            .member("center", view.center)
            .member("scale", view.pixels_per_metre)
            .close_object();
    json.close_array();
}

std::string header_of(const Checkpoint& checkpoint) {
    JsonWriter json(JsonWriter::Layout::compact);
    json.open_object().member("checkpoint", kVersion).member("settings", checkpoint.settings);
    json.member("pictures", checkpoint.pictures);
    json.key("tables").open_array();
    for (const SavedTable& table : checkpoint.tables)
        json.open_object()
            .member("kind", table.kind)
            .member("temporary", table.temporary)
            .member("bytes", table.bytes.count)
            .member("hash", table.bytes.hash)
            .close_object();
    json.close_array().member("frames", checkpoint.frames).member("frame_bytes", checkpoint.frame_bytes);
    const Camera& camera = checkpoint.view.camera;
    json.key("camera").open_object().member("center", camera.center).member("height", camera.height);
    json.member("index", camera.follows.index).member("generation", camera.follows.generation);
    json.member("offset", camera.offset).close_object();
    write_view_state(json, checkpoint.view);
    json.member("simulate", checkpoint.simulate_seconds).member("render", checkpoint.render_seconds);
    json.member("encode", checkpoint.encode_seconds).member("total", checkpoint.total_seconds);
    return json.close_object().text() + "\n";
}

// Throws if it is not a whole number that is not negative; get() would convert any number.
std::uint64_t whole(const Json& json) { return json.get_ref<const std::uint64_t&>(); }

std::uint32_t short_whole(const Json& json) {
    const std::uint64_t number = whole(json);
    if (number > std::numeric_limits<std::uint32_t>::max()) throw InputError("the id of a body is too large");
    return static_cast<std::uint32_t>(number);
}

DVec2 vector_of(const Json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

BodyId body_of(const Json& json) { return {short_whole(json.at("index")), short_whole(json.at("generation"))}; }

FrameOutput::State read_view_state(const Json& json) {
    FrameOutput::State state;
    const Json& camera = json.at("camera");
    state.camera = {vector_of(camera.at("center")), camera.at("height").get<double>()};
    state.camera.follows = body_of(camera);
    state.camera.offset = vector_of(camera.at("offset"));
    for (const Json& saved : json.at("trails")) {
        Trail trail{.body = body_of(saved), .stride = whole(saved.at("stride"))};
        if (trail.stride == 0) throw InputError("the stride of a trail is 0");
        for (const Json& point : saved.at("points")) trail.points.push_back(vector_of(point));
        state.trails.push_back(std::move(trail));
    }
    for (const Json& view : json.at("views"))
        state.views.push_back({whole(view.at("frame")), vector_of(view.at("center")), view.at("scale").get<double>()});
    return state;
}

// The name of a file in the folder of its table: a checkpoint from elsewhere must not reach other folders.
std::string file_name(const Json& json) {
    auto name = json.get<std::string>();
    if (name.empty() || fs::path(name).filename() != name) throw InputError("'" + name + "' is not the name of a file");
    return name;
}

Checkpoint read_header(const Json& json) {
    Checkpoint checkpoint;
    if (whole(json.at("checkpoint")) != kVersion) throw InputError("it is of another version");
    checkpoint.settings = json.at("settings").get<std::string>();
    checkpoint.pictures = whole(json.at("pictures"));
    for (const Json& table : json.at("tables"))
        checkpoint.tables.push_back({table.at("kind").get<std::string>(),
                                     file_name(table.at("temporary")),
                                     {whole(table.at("bytes")), whole(table.at("hash"))}});
    checkpoint.frames = whole(json.at("frames"));
    checkpoint.frame_bytes = whole(json.at("frame_bytes"));
    checkpoint.view = read_view_state(json);
    checkpoint.simulate_seconds = json.at("simulate").get<double>();
    checkpoint.render_seconds = json.at("render").get<double>();
    checkpoint.encode_seconds = json.at("encode").get<double>();
    checkpoint.total_seconds = json.at("total").get<double>();
    return checkpoint;
}

// The table of this kind; null if the run had none.
const SavedTable* find_table(const Checkpoint& saved, const std::string& kind) {
    const auto found = std::ranges::find(saved.tables, kind, &SavedTable::kind);
    return found == saved.tables.end() ? nullptr : &*found;
}

}  // namespace

void write_checkpoint(const fs::path& folder, const Checkpoint& checkpoint) {
    OutputFile file(checkpoint_file(folder));
    file.write(header_of(checkpoint));
    file.write({reinterpret_cast<const char*>(checkpoint.run.data()), checkpoint.run.size()});
    file.commit();
}

Checkpoint parse_checkpoint(std::string_view text) {
    const std::size_t line = std::min(text.find('\n'), text.size() - (text.empty() ? 0 : 1));
    try {
        Checkpoint checkpoint = read_header(Json::parse(text.substr(0, line)));
        const auto run = std::as_bytes(std::span(text).subspan(line + 1));
        checkpoint.run.assign(run.begin(), run.end());
        return checkpoint;
    } catch (const std::exception& error) {
        throw InputError(std::string("is not a checkpoint of this version: ") + error.what());
    }
}

Checkpoint read_checkpoint(const fs::path& folder, const std::string& settings) {
    const fs::path file = checkpoint_file(folder);
    if (!fs::exists(file)) throw FileError(folder, "contains no checkpoint; --checkpoint makes a run write them");
    Checkpoint checkpoint = [&] {
        try {
            return parse_checkpoint(read_file(file));
        } catch (const InputError& error) {
            throw InputError(file.string() + ": " + error.what());
        }
    }();
    if (checkpoint.settings != settings)
        throw CLI::ValidationError("--resume", "the run was begun with other settings: " + checkpoint.settings +
                                                   "; now they are: " + settings);
    return checkpoint;
}

std::vector<TableName> tables_of(const RunOptions& options) {
    std::vector<TableName> tables{{"events", events_file(options.folder)}};
    if (!options.contacts.empty()) tables.push_back({"contacts", options.contacts});
    if (!options.trajectory.empty()) tables.push_back({"trajectory", options.trajectory});
    if (!options.hashes.empty()) tables.push_back({"hashes", options.hashes});
    return tables;
}

std::string settings_of(const RunOptions& options) {
    std::string text = "no frames";
    if (!options.no_frames) {
        append_number(text = "frames ", options.frames_per_second);
        text += "/s " + std::to_string(options.size.width) + "x" + std::to_string(options.size.height);
        for (const SlowMotion& part : options.slow) {
            append_number(text += " slow ", part.from);
            append_number(text += ":", part.to);
            append_number(text += ":", part.speed);
        }
        for (const OverlayPart& part : kOverlayParts)
            if (options.overlay.*part.member) text += " " + std::string(part.name);
        for (const OverlayPart& part : kFrameParts)
            if (!(options.overlay.*part.member)) text += " without " + std::string(part.name);
        for (const ThemeName& theme : kThemes)
            if (options.overlay.theme == theme.theme) text += " theme " + std::string(theme.name);
        for (const BackendName& backend : kBackends)
            if (options.renderer == backend.backend) text += " renderer " + std::string(backend.name);
    }
    for (const TableName& table : tables_of(options)) text += ", " + table.kind + " " + table.file.filename().string();
    return text;
}

SceneRun load_run(const Scene& scene, const Checkpoint& saved, const fs::path& folder) {
    try {
        return SceneRun::load(scene, saved.run);
    } catch (const SnapshotError& error) {
        throw InputError(checkpoint_file(folder).string() + ": " + error.what());
    }
}

void require_pictures(const Checkpoint& saved, std::uint64_t pictures, const fs::path& folder) {
    if (saved.pictures != pictures)
        throw InputError(checkpoint_file(folder).string() +
                         ": the frames before it look different: the name, the camera, the style, notes, colours, "
                         "trails, skins or images of the scene were changed, or its duration, to which the view is "
                         "fitted. Restore them (--duration lengthens the run and keeps the view), or begin the run "
                         "again with --force");
}

void keep_tables(const Checkpoint& saved, const RunOptions& options) {
    const std::vector<TableName> tables = tables_of(options);
    for (const TableName& table : tables) {
        const SavedTable* const before = find_table(saved, table.kind);
        const fs::path temporary = before == nullptr ? "" : table.file.parent_path() / before->temporary;
        if (fs::is_regular_file(temporary)) fs::rename(temporary, earlier_part_of(table.file));
    }
    remove_partial_files(options.folder);
    for (const TableName& table : tables) remove_dead_parts_of(table.file);
}

void continue_table(const Checkpoint& saved, const std::string& kind, TableFile& file) {
    const SavedTable* const table = find_table(saved, kind);
    if (table == nullptr) throw FileError(file.path(), "the checkpoint does not have this table");
    bool exists = false;
    for (const fs::path& candidate : {earlier_part_of(file.path()), file.path()}) {
        if (!fs::exists(candidate)) continue;
        exists = true;
        if (file.continue_from(candidate, table->bytes)) return;
    }
    if (!exists) throw FileError(file.path(), "the table of the interrupted run is missing");
    throw InputError(file.path().string() +
                     ": is not the table of the interrupted run, or was changed since the checkpoint; restore it, or "
                     "begin the run again with --force");
}

void remove_kept_tables(const RunOptions& options) {
    for (const TableName& table : tables_of(options)) fs::remove(earlier_part_of(table.file));
}

}  // namespace tumble::tools
