#include "tools/run/run_folder.hpp"

#include <string>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

void remove_earlier_run(const fs::path& folder) {
    const fs::path frames = folder / "frames";
    if (fs::is_directory(frames))
        for (const fs::directory_entry& entry : fs::directory_iterator(frames))
            if (is_frame(entry.path())) fs::remove(entry.path());
    remove_partial_files(folder);
    fs::remove(summary_file(folder));
    fs::remove(events_file(folder));
    fs::remove(earlier_part_of(events_file(folder)));
    fs::remove(checkpoint_file(folder));
}

}  // namespace

bool is_frame(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with("frame_") && file.extension() == ".png";
}

fs::path frame_file(const fs::path& folder, std::uint64_t frame) {
    std::string digits = std::to_string(frame);
    if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
    return folder / "frames" / ("frame_" + digits + ".png");
}

fs::path summary_file(const fs::path& folder) { return folder / "summary.json"; }

fs::path checkpoint_file(const fs::path& folder) { return folder / "checkpoint"; }

fs::path events_file(const fs::path& folder) { return folder / "events.csv"; }

void remove_partial_files(const fs::path& folder) {
    for (const PartialFile& partial : find_partial_files(folder))
        for (const fs::path& file : {summary_file(folder), events_file(folder), checkpoint_file(folder)})
            if (partial.file == file) fs::remove(partial.path);
    for (const PartialFile& partial : find_partial_files(folder / "frames"))
        if (is_frame(partial.file)) fs::remove(partial.path);
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

void clear_run_folder(const fs::path& folder, bool with_frames) {
    remove_earlier_run(folder);
    std::error_code error;
    const fs::path innermost = with_frames ? folder / "frames" : folder;
    fs::create_directories(innermost, error);
    if (error) throw FileError(innermost, "cannot create the folder: " + error.message());
}

}  // namespace tumble::tools
