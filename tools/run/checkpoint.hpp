// The checkpoint of a run: what `run --resume` needs to continue it as if it had not been interrupted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/run/run_options.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// A table as far as it was written. Its bytes are in the temporary file or, after an orderly end, in the file.
struct SavedTable {
    std::string kind;  // "events", "trajectory", "contacts", "hashes"
    std::filesystem::path temporary;
    std::filesystem::path file;
    std::uint64_t bytes = 0;
};

struct Checkpoint {
    std::string settings;  // of frames and tables: a run that continues must have the same
    std::vector<SavedTable> tables;
    std::uint64_t frames = 0;       // drawn so far
    std::uint64_t frame_bytes = 0;  // of their files
    Camera camera;
    double simulate_seconds = 0.0, render_seconds = 0.0, encode_seconds = 0.0, total_seconds = 0.0;
    std::vector<std::byte> run;  // SceneRun::save()
};

// Replaces checkpoint_file() as a whole, so that it is complete at any time. Throws FileError.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

// Throws FileError if the folder has no checkpoint, InputError if it is damaged, CLI::ValidationError if the run was
// begun with other settings.
Checkpoint read_checkpoint(const std::filesystem::path& folder, const std::string& settings);

// What a run and its continuation must have in common: "frames 60/s 1280x720, trajectory t.csv".
std::string settings_of(const RunOptions& options);

// Throws InputError if the checkpoint is damaged or belongs to another scene, SceneError as SceneRun does.
SceneRun load_run(const Scene& scene, const Checkpoint& saved, const std::filesystem::path& folder);

// Gives the temporary tables of the interrupted run names that no process writes to, and removes what else it has not
// completed. The caller holds the lock of the folder.
void keep_tables(const Checkpoint& saved, const std::filesystem::path& folder);

// Appends what the interrupted run had written to a table at the checkpoint. `file` may contain the header already.
// Throws FileError if that is not there.
void continue_table(const Checkpoint& saved, const std::string& kind, OutputFile& file);

// Removes the files of keep_tables(), when a later checkpoint or the results replace them.
void remove_kept_tables(const Checkpoint& saved);

}  // namespace tumble::tools
