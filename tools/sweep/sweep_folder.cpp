#include "tools/sweep/sweep_folder.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "sweep/store/stored_file.hpp"
#include "tools/output/input_error.hpp"
#include "tools/sweep/runs/scene_texts.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

bool has_size(const fs::path& folder, const sweep::StoredFile& file) {
    std::error_code error;
    return fs::file_size(folder / file.name, error) == file.bytes && !error;
}

// Lines of the table, with a checksum that holds.
std::string read_lines(const fs::path& folder, const sweep::StoredFile& lines) {
    std::string text = read_file(folder / lines.name);
    if (sweep::hash_of(text) != lines.hash)
        throw InputError((folder / lines.name).string() +
                         ": the checksum is not that of the manifest; run the sweep again with --check");
    return text;
}

void write_table(const fs::path& folder, sweep::Manifest& manifest) {
    sweep::StoredFileWriter table(folder, sweep::table_file(folder).filename().string());
    table.write(manifest.header->columns);
    for (const auto& [shard, entry] : manifest.shards) table.write(read_lines(folder, entry.table));
    manifest.table = table.commit();
}

// What killed processes have left in the folder and in the copies of the scenes.
void remove_leftovers(const fs::path& folder) {
    std::vector<fs::path> folders{folder};
    if (has_copies(folder)) {
        folders.push_back(copies_in(folder));
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(copies_in(folder)))
            if (entry.is_directory() && !entry.is_symlink()) folders.push_back(entry.path());
    }
    for (const fs::path& searched : folders)
        for (const PartialFile& file : find_partial_files(searched))
            if (!file.is_open) fs::remove(file.path);
}

}  // namespace

bool is_stored(const fs::path& folder, const sweep::Manifest& manifest, std::uint64_t shard) {
    const auto entry = manifest.shards.find(shard);
    if (entry == manifest.shards.end()) return false;
    const bool has_lines =
        has_size(folder, entry->second.table) || (manifest.table && has_size(folder, *manifest.table));
    return has_lines && std::ranges::all_of(entry->second.files,
                                            [&](const sweep::StoredFile& file) { return has_size(folder, file); });
}

ShardRanges missing_shards(const fs::path& folder, const sweep::Manifest& manifest) {
    ShardRanges missing;
    const std::uint64_t count = manifest.header ? manifest.header->shards() : 0;
    std::uint64_t next = 0;  // the first shard that is not decided
    const auto add_up_to = [&](std::uint64_t end) {
        if (end <= next) return;
        if (!missing.empty() && missing.back().second + 1 == next)
            missing.back().second = end - 1;
        else
            missing.emplace_back(next, end - 1);
    };
    for (const auto& [shard, entry] : manifest.shards) {
        if (!is_stored(folder, manifest, shard)) continue;
        add_up_to(shard);
        next = shard + 1;
    }
    add_up_to(count);
    return missing;
}

sweep::Manifest manifest_of_sweep(const fs::path& folder) {
    sweep::Manifest manifest = sweep::read_manifest(folder);
    if (!manifest.header) throw FileError(folder, "has no sweep: there is no manifest.jsonl with its first line");
    return manifest;
}

bool is_complete(const fs::path& folder, const sweep::Manifest& manifest) {
    return manifest.header && manifest.table && has_size(folder, *manifest.table) &&
           missing_shards(folder, manifest).empty();
}

void complete_folder(const fs::path& folder) {
    sweep::Manifest manifest = sweep::read_manifest(folder);
    if (!is_complete(folder, manifest)) write_table(folder, manifest);
    remove_leftovers(folder);
    sweep::write_manifest(folder, manifest);
    for (const auto& [shard, entry] : manifest.shards) fs::remove(folder / entry.table.name);
}

}  // namespace tumble::tools
