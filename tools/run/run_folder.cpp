#include "tools/run/run_folder.hpp"

#include <string>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

void remove_earlier_run(const fs::path& folder) {
    for (const char* const images : {"frames", "masks"})
        if (fs::is_directory(folder / images))
            for (const fs::directory_entry& entry : fs::directory_iterator(folder / images))
                if (is_frame(entry.path()) || is_mask(entry.path())) fs::remove(entry.path());
    remove_partial_files(folder);
    for (const PartialFile& partial : find_partial_files(folder))  // of tables
        if (!partial.is_open) fs::remove(partial.path);
    fs::remove(labels_file(folder));
    fs::remove(boxes_file(folder));
    fs::remove(summary_file(folder));
    fs::remove(events_file(folder));
    fs::remove(earlier_part_of(events_file(folder)));
    fs::remove(checkpoint_file(folder));
}

bool is_png_called(const fs::path& file, const char* start) {
    return file.filename().string().starts_with(start) && file.extension() == ".png";
}

// folder/mask_000000.png, for "mask_"
fs::path numbered(const fs::path& folder, const std::string& start, std::uint64_t frame) {
    std::string digits = std::to_string(frame);
    if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
    return folder / (start + digits + ".png");
}

void create_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder: " + error.message());
}

}  // namespace

bool is_frame(const fs::path& file) { return is_png_called(file, "frame_"); }

bool is_mask(const fs::path& file) { return is_png_called(file, "mask_"); }

fs::path frame_file(const fs::path& folder, std::uint64_t frame) {
    return numbered(folder / "frames", "frame_", frame);
}

fs::path mask_file(const fs::path& folder, std::uint64_t frame) { return numbered(folder / "masks", "mask_", frame); }

fs::path labels_file(const fs::path& folder) { return folder / "labels.json"; }

fs::path boxes_file(const fs::path& folder) { return folder / "boxes.json"; }

fs::path summary_file(const fs::path& folder) { return folder / "summary.json"; }

fs::path checkpoint_file(const fs::path& folder) { return folder / "checkpoint"; }

fs::path events_file(const fs::path& folder) { return folder / "events.csv"; }

void remove_partial_files(const fs::path& folder) {
    for (const PartialFile& partial : find_partial_files(folder))
        for (const fs::path& file : {summary_file(folder), events_file(folder), checkpoint_file(folder),
                                     labels_file(folder), boxes_file(folder)})
            if (partial.file == file) fs::remove(partial.path);
    for (const char* const images : {"frames", "masks"})
        for (const PartialFile& partial : find_partial_files(folder / images))
            if (is_frame(partial.file) || is_mask(partial.file)) fs::remove(partial.path);
}

void remove_dead_parts_of(const fs::path& file) {
    for (const PartialFile& partial : find_partial_files(file.has_parent_path() ? file.parent_path() : "."))
        if (partial.file.filename() == file.filename() && !partial.is_open) fs::remove(partial.path);
}

fs::path earlier_part_of(const fs::path& file) {
    fs::path name = file;
    return name += ".earlier";
}

void refuse_used_folder(const fs::path& folder, bool force) {
    std::error_code ignored;
    if (!force && fs::is_directory(folder, ignored) && !fs::is_empty(folder, ignored))
        throw FileError(folder,
                        "the folder is not empty; choose another with -o, or replace the results in it with --force");
}

void clear_run_folder(const fs::path& folder, bool with_frames, bool with_masks) {
    remove_earlier_run(folder);
    create_folder(folder);
    if (with_frames) create_folder(folder / "frames");
    if (with_masks) create_folder(folder / "masks");
}

}  // namespace tumble::tools
