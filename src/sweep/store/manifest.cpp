#include "sweep/store/manifest.hpp"

#ifndef __clang_analyzer__
#define XXH_INLINE_ALL
#endif
#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "sweep/store/durable.hpp"
#include "tumble/file.hpp"

namespace tumble::sweep {

namespace fs = std::filesystem;

namespace {

using LineJson = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1 << 30;                      // of a manifest: three million shards
constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 53;  // of runs, in the folder and in a shard

std::string hex(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::uint64_t from_hex(const LineJson& text) { return std::stoull(text.get<std::string>(), nullptr, 16); }

LineJson to_json(const StoredFile& file) {
    return {{"name", file.name}, {"bytes", file.bytes}, {"xxh64", hex(file.hash)}};
}

// Throws if it is not a whole number that is not negative; get() would convert any number.
std::uint64_t whole(const LineJson& json) { return json.get_ref<const std::uint64_t&>(); }

StoredFile to_file(const LineJson& json) {
    return {json.at("name").get<std::string>(), whole(json.at("bytes")), from_hex(json.at("xxh64"))};
}

StoredFile to_file(const LineJson& json, const std::set<std::string>& names) {
    StoredFile file = to_file(json);
    if (!names.contains(file.name)) throw std::invalid_argument("not a file of a sweep");
    return file;
}

// A file below DIR/plan.
StoredFile to_copy(const LineJson& json) {
    StoredFile file = to_file(json);
    const fs::path path(file.name);
    if (!file.name.starts_with("plan/") || !path.has_filename() || path.lexically_normal() != path)
        throw std::invalid_argument("not a copy of a sweep");
    return file;
}

std::string line_of(const SweepHeader& header) {
    LineJson json{{"plan", hex(header.plan)},
                  {"runs", header.runs},
                  {"shard_runs", header.shard_runs},
                  {"version", header.version},
                  {"columns", header.columns}};
    if (!header.plan_file.empty()) json["plan_file"] = header.plan_file;
    if (!header.frame_software.empty()) json["frame_software"] = header.frame_software;
    return json.dump();
}

LineJson to_json(const std::vector<StoredFile>& files) {
    LineJson array = LineJson::array();
    for (const StoredFile& file : files) array.push_back(to_json(file));
    return array;
}

LineJson to_json(const ShardEntry& entry) {
    return {{"shard", entry.shard},
            {"outcomes", entry.outcomes},
            {"table", to_json(entry.table)},
            {"files", to_json(entry.files)}};
}

std::string line_of(const ShardEntry& entry) {
    LineJson json = to_json(entry);
    if (!entry.copies.empty()) json["copies"] = to_json(entry.copies);
    return json.dump();
}

std::string line_of(const StoredFile& table, const std::vector<StoredFile>& copies) {
    LineJson json{{"complete", to_json(table)}};
    if (!copies.empty()) json["copies"] = to_json(copies);
    return json.dump();
}

std::vector<StoredFile> copies_in(const LineJson& line) {
    std::vector<StoredFile> copies;
    for (const LineJson& copy : line.value("copies", LineJson::array())) copies.push_back(to_copy(copy));
    return copies;
}

void add_copies(Manifest& manifest, const std::vector<StoredFile>& copies) {
    manifest.copies.insert(manifest.copies.end(), copies.begin(), copies.end());
}

// The first checksum of a copy stays: it may be damaged since.
void drop_repeated(std::vector<StoredFile>& copies) {
    std::ranges::stable_sort(copies, {}, &StoredFile::name);
    const auto same_name = [](const StoredFile& a, const StoredFile& b) { return a.name == b.name; };
    copies.erase(std::unique(copies.begin(), copies.end(), same_name), copies.end());
}

// Reads one line; throws an exception of the JSON library or std::invalid_argument if it is none of a manifest.
void read_line(const std::string& line, Manifest& manifest, const fs::path& file) {
    const LineJson json = LineJson::parse(line);
    if (json.contains("plan")) {
        const SweepHeader header{from_hex(json.at("plan")),
                                 whole(json.at("runs")),
                                 whole(json.at("shard_runs")),
                                 json.at("version").get<std::string>(),
                                 json.at("columns").get<std::string>(),
                                 json.value("plan_file", ""),
                                 json.value("frame_software", "")};
        if (fs::path(header.plan_file).filename() != header.plan_file)
            throw FileError(file, "names a plan outside of its folder");
        for (const std::uint64_t runs : {header.runs, header.shard_runs})
            if (runs == 0 || runs > kLargestCount) throw FileError(file, "states an impossible number of runs");
        if (manifest.header && !(*manifest.header == header)) throw FileError(file, "is of two sweeps");
        manifest.header = header;
    } else if (json.contains("shard")) {
        ShardEntry entry{.shard = whole(json.at("shard"))};
        for (const auto& [outcome, count] : json.at("outcomes").items()) entry.outcomes[outcome] = whole(count);
        entry.table = to_file(json.at("table"), {shard_file_name(entry.shard, ".csv")});
        for (const LineJson& stored : json.at("files"))
            entry.files.push_back(
                to_file(stored, {shard_file_name(entry.shard, ".tar"), shard_file_name(entry.shard, ".h5")}));
        entry.copies = copies_in(json);
        add_copies(manifest, entry.copies);
        manifest.shards.insert_or_assign(entry.shard, entry);
    } else {
        const std::vector<StoredFile> copies = copies_in(json);
        manifest.table = to_file(json.at("complete"), {table_file({}).string()});
        add_copies(manifest, copies);
    }
}

[[noreturn]] void fail(const fs::path& file, int error) {
    throw FileError(file, "cannot write: " + std::generic_category().message(error));
}

// A line feed before the line ends one that another process has not completed.
void append_line(const fs::path& folder, const std::string& line) {
    const fs::path file = manifest_file(folder);
    const std::string text = "\n" + line + "\n";
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(file, errno);
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    const int error = written < 0 ? errno : ENOSPC;
    const bool is_whole = written == static_cast<ssize_t>(text.size());
    if (::close(descriptor) != 0 || !is_whole) fail(file, is_whole ? errno : error);
    make_durable(file);
}

}  // namespace

std::uint64_t hash_of(std::string_view bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

fs::path manifest_file(const fs::path& folder) { return folder / "manifest.jsonl"; }
fs::path table_file(const fs::path& folder) { return folder / "runs.csv"; }

std::string shard_file_name(std::uint64_t shard, std::string_view extension) {
    char text[32];
    std::snprintf(text, sizeof text, "shard-%06llu", static_cast<unsigned long long>(shard));
    return text + std::string(extension);
}

Manifest read_manifest(const fs::path& folder) {
    Manifest manifest;
    const fs::path file = manifest_file(folder);
    if (!fs::exists(file)) return manifest;
    const std::string bytes = read_file(file, kMostBytes);
    if (bytes.size() > kMostBytes) throw FileError(file, "is longer than 1 GiB");
    std::istringstream text(bytes);
    for (std::string line; std::getline(text, line);) {
        if (line.empty()) continue;
        try {
            read_line(line, manifest, file);
        } catch (const LineJson::exception&) {
            ++manifest.damaged_lines;
        } catch (const std::logic_error&) {
            ++manifest.damaged_lines;
        }
    }
    drop_repeated(manifest.copies);
    const std::uint64_t shards = manifest.header ? manifest.header->shards() : 0;
    manifest.damaged_lines += std::erase_if(manifest.shards, [&](const auto& entry) { return entry.first >= shards; });
    return manifest;
}

void append_header(const fs::path& folder, const SweepHeader& header) { append_line(folder, line_of(header)); }
void append_shard(const fs::path& folder, const ShardEntry& entry) { append_line(folder, line_of(entry)); }

void write_manifest(const fs::path& folder, const Manifest& manifest) {
    OutputFile file(manifest_file(folder));
    if (manifest.header) file.write(line_of(*manifest.header) + "\n");
    for (const auto& [shard, entry] : manifest.shards) file.write(to_json(entry).dump() + "\n");
    if (manifest.table) file.write(line_of(*manifest.table, manifest.copies) + "\n");
    file.save_so_far();
    make_durable(file.temporary());
    file.commit();
    make_durable(folder);
}

}  // namespace tumble::sweep
