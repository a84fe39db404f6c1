// The manifest of a sweep's folder: which shards are complete, with the checksums of their files.
//
// manifest.jsonl has a JSON object on each line. While the sweep runs, processes append lines. A line that is cut off
// counts as absent, so that its shard is simulated again. At the end the file is rewritten in the order of the shards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::sweep {

struct StoredFile {
    std::string name;  // in the folder of the sweep
    std::uint64_t bytes = 0;
    std::uint64_t hash = 0;  // XXH64
};

std::uint64_t hash_of(std::string_view bytes);

// What all processes on one folder must agree on.
struct SweepHeader {
    std::uint64_t plan = 0;  // Plan::hash
    std::uint64_t runs = 1;
    std::uint64_t shard_runs = 1;
    std::string version;           // of tumble
    std::string columns;           // the first line of the table
    std::string plan_file{};       // its name in DIR/plan; empty if the plan was not copied
    std::string frame_software{};  // on which the bytes of frames depend: OpenGL and ffmpeg; empty without frames

    bool operator==(const SweepHeader&) const = default;
    std::uint64_t shards() const { return (runs - 1) / shard_runs + 1; }
};

struct ShardEntry {
    std::uint64_t shard = 0;
    std::map<std::string, std::uint64_t> outcomes{};  // how many runs ended so
    StoredFile table{};                               // its lines of runs.csv: a file until the sweep is complete
    std::vector<StoredFile> files{};
    std::vector<StoredFile> copies{};  // that its process has made since its last entry; until the sweep is complete
};

struct Manifest {
    std::optional<SweepHeader> header{};
    std::map<std::uint64_t, ShardEntry> shards{};
    std::optional<StoredFile> table{};  // runs.csv of a complete sweep
    std::vector<StoredFile> copies{};   // of the plan, its scenes and images, by their names
    std::size_t damaged_lines = 0;      // cut off, or not those of a manifest
};

std::filesystem::path manifest_file(const std::filesystem::path& folder);
std::filesystem::path table_file(const std::filesystem::path& folder);

// "shard-000003.csv"
std::string shard_file_name(std::uint64_t shard, std::string_view extension);

// Empty if there is none. A manifest from elsewhere names no other files than those of its own folder. Throws
// FileError, also for first lines that contradict each other or have impossible numbers.
Manifest read_manifest(const std::filesystem::path& folder);

// Appends a line in one piece. Throws FileError.
void append_header(const std::filesystem::path& folder, const SweepHeader& header);
void append_shard(const std::filesystem::path& folder, const ShardEntry& entry);

// Replaces the manifest by that of a complete sweep.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

}  // namespace tumble::sweep
