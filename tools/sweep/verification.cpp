#include "tools/sweep/verification.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <system_error>

#include "sweep/plan/permutation.hpp"
#include "sweep/store/stored_file.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/output/csv_table.hpp"
#include "tools/sweep/runs/run_record.hpp"
#include "tools/sweep/runs/scene_texts.hpp"
#include "tools/sweep/sweep_folder.hpp"
#include "tools/sweep/table_reader.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

void verify_file(const fs::path& folder, const sweep::StoredFile& expected, Verification& verification) {
    const fs::path path = folder / expected.name;
    if (!fs::is_regular_file(path)) {
        verification.findings.push_back(path.string() + ": is missing, or no regular file");
        return;
    }
    const sweep::StoredFile found = sweep::read_stored_file(folder, expected.name);
    ++verification.files;
    verification.bytes += found.bytes;
    if (found.bytes != expected.bytes)
        verification.findings.push_back(path.string() + ": has " + std::to_string(found.bytes) + " bytes instead of " +
                                        std::to_string(expected.bytes));
    else if (found.hash != expected.hash)
        verification.findings.push_back(path.string() + ": its checksum is not that of the manifest");
}

// Of the complete shards, and the table.
std::vector<sweep::StoredFile> stored_files(const sweep::Manifest& manifest) {
    std::vector<sweep::StoredFile> files;
    for (const auto& [shard, entry] : manifest.shards) {
        files.insert(files.end(), entry.files.begin(), entry.files.end());
        if (!manifest.table) files.push_back(entry.table);
    }
    if (manifest.table) files.push_back(*manifest.table);
    return files;
}

// Whether the same command would give other results on another machine, or at another time.
bool depends_on_machine(const std::string& line, std::size_t outcome_column) {
    const std::optional<std::vector<std::string>> cells = cells_of(line);
    if (!cells || cells->size() <= outcome_column) return false;
    const std::string& outcome = (*cells)[outcome_column];
    return outcome == "timed_out" || outcome == "failed" || outcome == "crashed";
}

// The lines of a table by their first number, the run. Messages are on one line.
std::map<std::uint64_t, std::string> read_rows(const fs::path& file, const std::set<std::uint64_t>& wanted) {
    std::map<std::uint64_t, std::string> rows;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        std::uint64_t run = 0;
        if (std::from_chars(line.data(), line.data() + line.size(), run).ec != std::errc()) continue;
        if (wanted.contains(run)) rows.emplace(run, line + "\n");
    }
    return rows;
}

// Different runs of the complete shards, of which only the last of the plan may be shorter than the others.
std::set<std::uint64_t> draw_runs(const sweep::Plan& plan, const fs::path& folder, const sweep::Manifest& manifest,
                                  double part, std::uint64_t seed) {
    const std::uint64_t shard_runs = runs_in_shard(plan);
    std::vector<std::uint64_t> stored;
    for (const auto& [shard, entry] : manifest.shards)
        if (is_stored(folder, manifest, shard)) stored.push_back(shard);
    if (stored.empty()) return {};
    const std::uint64_t last = std::min(plan.runs - stored.back() * shard_runs, shard_runs);
    const std::uint64_t stored_runs = (stored.size() - 1) * shard_runs + last;
    const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(stored_runs)));
    std::set<std::uint64_t> runs;
    for (std::uint64_t i = 0; i < std::max<std::uint64_t>(wanted, 1); ++i) {
        const std::uint64_t place = sweep::permuted(i, stored_runs, seed);
        runs.insert(stored[place / shard_runs] * shard_runs + place % shard_runs);
    }
    return runs;
}

}  // namespace

Verification verify_files(const fs::path& folder) {
    const sweep::Manifest manifest = manifest_of_sweep(folder);
    Verification verification;
    for (const sweep::StoredFile& file : manifest.copies) verify_file(folder, file, verification);
    verification.has_damaged_copies = !verification.findings.empty();
    for (const sweep::StoredFile& file : stored_files(manifest)) verify_file(folder, file, verification);
    const std::uint64_t shards = manifest.header->shards();
    if (manifest.shards.size() < shards)
        verification.findings.push_back(folder.string() + ": " + std::to_string(shards - manifest.shards.size()) +
                                        " of " + std::to_string(shards) + " shards are not written");
    return verification;
}

void remove_damaged_files(const fs::path& folder) {
    const sweep::Manifest manifest = sweep::read_manifest(folder);
    std::vector<sweep::StoredFile> files = stored_files(manifest);
    files.insert(files.end(), manifest.copies.begin(), manifest.copies.end());
    for (const sweep::StoredFile& file : files) {
        if (is_interrupted()) return;
        std::error_code error;
        if (is_behind_link(folder, file.name)) continue;
        if (!fs::is_regular_file(folder / file.name) || sweep::read_stored_file(folder, file.name).hash == file.hash)
            continue;
        if (!fs::remove(folder / file.name, error)) throw FileError(folder / file.name, "cannot remove the file");
    }
}

void verify_runs(const sweep::Plan& plan, const fs::path& folder, double part, Verification& verification) {
    const sweep::Manifest manifest = manifest_of_sweep(folder);
    const sweep::SweepHeader& header = *manifest.header;
    if (header.plan != plan.hash || header.runs != plan.runs || header.shard_runs != runs_in_shard(plan))
        throw FileError(folder, "is of another plan than " + plan.file.string());
    if (header.frame_software != frame_software(plan.write))
        throw FileError(folder, "has frames of " + header.frame_software + ", and this machine draws by " +
                                    frame_software(plan.write) + ": their bytes may differ");
    const std::set<std::uint64_t> runs = draw_runs(plan, folder, manifest, part, verification.seed);
    std::map<std::uint64_t, std::string> rows;
    if (manifest.table)
        rows = read_rows(sweep::table_file(folder), runs);
    else
        for (const std::uint64_t run : runs)
            rows.merge(read_rows(folder / manifest.shards.at(run / runs_in_shard(plan)).table.name, {run}));
    // The columns before `outcome` have plain names.
    const std::string& columns = header.columns;
    const auto outcome =
        static_cast<std::size_t>(std::ranges::count(columns.substr(0, columns.find(",outcome,") + 1), ','));
    SceneTexts texts;
    RunMaker maker(plan, texts);
    for (const std::uint64_t run : runs) {
        const auto row = rows.find(run);
        if (row != rows.end() && depends_on_machine(row->second, outcome)) continue;
        const RunRecord record = maker.make(run);
        ++verification.repeated_runs;
        if (row == rows.end())
            verification.findings.push_back("run " + std::to_string(run) + ": is not in the table");
        else if (row->second != record.row)
            verification.findings.push_back("run " + std::to_string(run) + ": the table has\n  " + row->second +
                                            "and the run gives\n  " + record.row.substr(0, record.row.size() - 1));
    }
}

}  // namespace tumble::tools
