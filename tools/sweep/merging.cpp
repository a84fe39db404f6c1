#include "tools/sweep/merging.hpp"

#include <system_error>
#include <utility>
#include <vector>

#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"
#include "tools/output/input_error.hpp"
#include "tools/sweep/runs/scene_texts.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

// Copies `file` from the bytes of another file that begin at `start`. Throws InputError, and leaves no copy, if their
// checksum is another.
void copy_bytes(const fs::path& from, std::uint64_t start, const fs::path& to, const sweep::StoredFile& file) {
    OutputFile copy(to / file.name);
    copy.append_from(from, start, start + file.bytes);
    copy.save_so_far();
    if (sweep::read_stored_file(to, copy.temporary().filename().string()).hash != file.hash)
        throw InputError(from.string() + ": the checksum of its bytes is not that of its manifest");
    sweep::make_durable(copy.temporary());
    copy.commit();
}

void copy_file(const fs::path& from, const fs::path& to, const sweep::StoredFile& file) {
    copy_bytes(from / file.name, 0, to, file);
}

// The table of a complete part is one file, which has to be cut again.
void copy_lines(const fs::path& from, const sweep::Manifest& part, const fs::path& to, const sweep::ShardEntry& entry) {
    if (fs::exists(from / entry.table.name)) return copy_file(from, to, entry.table);
    std::uint64_t start = part.header->columns.size();
    for (const auto& [shard, other] : part.shards)
        if (shard < entry.shard) start += other.table.bytes;
    copy_bytes(sweep::table_file(from), start, to, entry.table);
}

void add_part(const fs::path& folder, const fs::path& from, sweep::Manifest& manifest) {
    const sweep::Manifest part = manifest_of_sweep(from);
    if (!manifest.header) {
        append_header(folder, *part.header);
        manifest.header = part.header;
    }
    if (!(*manifest.header == *part.header)) throw FileError(from, "is of another sweep than " + folder.string());
    merge_copies(from, part.copies, folder);
    std::vector<sweep::StoredFile> copies = part.copies;
    for (auto [shard, entry] : part.shards) {
        if (is_stored(folder, manifest, shard) || !is_stored(from, part, shard)) continue;
        entry.copies = std::exchange(copies, {});  // of all its shards
        for (const sweep::StoredFile& file : entry.files) copy_file(from, folder, file);
        copy_lines(from, part, folder, entry);
        sweep::make_durable(folder);  // the names of the shard's files
        append_shard(folder, entry);
        manifest.shards.insert_or_assign(shard, entry);
    }
}

}  // namespace

ShardRanges merge_folders(const fs::path& folder, const std::vector<fs::path>& parts) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder: " + error.message());
    sweep::Manifest manifest = sweep::read_manifest(folder);
    for (const fs::path& part : parts) add_part(folder, part, manifest);
    if (!manifest.header) throw FileError(folder, "has no sweep: there is no manifest.jsonl with its first line");
    ShardRanges missing = missing_shards(folder, manifest);
    if (missing.empty()) {
        complete_folder(folder);
        fs::remove_all(folder / "leases", error);
    }
    return missing;
}

}  // namespace tumble::tools
