// The checkpoint of a run: a file with the state of the simulation, of the tables and of the camera after a step.
// `run --resume` reads it and continues the run; the results are the same as without the interruption.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/run/frame_output.hpp"
#include "tools/run/run_options.hpp"
#include "tools/tables/table_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

// A table of a run.
struct TableName {
    std::string kind;  // "events", "trajectory", "contacts", "hashes"
    std::filesystem::path file;
};

// The tables that a run with these options writes.
std::vector<TableName> tables_of(const RunOptions& options);

// A table up to a checkpoint. Its bytes are in the temporary file or, if a signal ended the run, in the table itself.
// Both are in the folder that the options of the continuing run name, so that the folders may be moved.
struct SavedTable {
    std::string kind;
    std::string temporary;  // the name of the file, without its folder
    TableBytes bytes;
};

struct Checkpoint {
    std::string settings;        // settings_of() the interrupted run
    std::uint64_t pictures = 0;  // its picture_hash(); 0 without frames
    std::vector<SavedTable> tables;
    std::uint64_t frames = 0;       // drawn so far
    std::uint64_t frame_bytes = 0;  // of their files
    FrameOutput::State view;        // camera and trails
    double simulate_seconds = 0.0, render_seconds = 0.0, encode_seconds = 0.0, total_seconds = 0.0;
    std::vector<std::byte> run;  // SceneRun::save()
};

// Replaces checkpoint_file() as a whole, so that it is complete at any time. Throws FileError.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

// The checkpoint of these bytes. Throws InputError, without the name of the file, if they are damaged.
Checkpoint parse_checkpoint(std::string_view text);

// Throws FileError if the folder has no checkpoint, InputError if it is damaged, CLI::ValidationError if the run was
// begun with other settings.
Checkpoint read_checkpoint(const std::filesystem::path& folder, const std::string& settings);

// The options that a run and its continuation must have in common: "frames 60/s 1280x720 theme dark renderer auto,
// trajectory t.csv". Of tables it has the names without their folders.
std::string settings_of(const RunOptions& options);

// Throws InputError if the checkpoint is damaged or belongs to another scene, SceneError as SceneRun does.
SceneRun load_run(const Scene& scene, const Checkpoint& saved, const std::filesystem::path& folder);

// Throws InputError if frames with this picture_hash() would differ from those before the checkpoint.
void require_pictures(const Checkpoint& saved, std::uint64_t pictures, const std::filesystem::path& folder);

// Renames each temporary table of the interrupted run to earlier_part_of() the table, and removes its other temporary
// files. The caller holds the lock of the folder.
void keep_tables(const Checkpoint& saved, const RunOptions& options);

// Appends the bytes that the table had at the checkpoint. `file` has the header already. Throws FileError if the table
// is missing, InputError if its bytes have changed since.
void continue_table(const Checkpoint& saved, const std::string& kind, TableFile& file);

// Removes the files of keep_tables(), when a later checkpoint or the results replace them.
void remove_kept_tables(const RunOptions& options);

}  // namespace tumble::tools
