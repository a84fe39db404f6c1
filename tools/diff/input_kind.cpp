#include "tools/diff/input_kind.hpp"

#include <algorithm>
#include <istream>
#include <memory>
#include <string>

#include "tools/diff/summary_diff.hpp"
#include "tools/output/standard_input.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

bool has_pictures(const fs::path& folder) {
    if (!fs::is_directory(folder)) return false;
    return std::ranges::any_of(fs::directory_iterator(folder),
                               [](const fs::directory_entry& entry) { return entry.path().extension() == ".png"; });
}

InputKind kind_of_table(const fs::path& file) {
    const std::unique_ptr<std::istream> stream = open_input(file);
    std::string header;
    std::getline(*stream, header);
    if (header.starts_with("step,hash")) return InputKind::hashes;
    return header.starts_with("step,time,event") ? InputKind::events : InputKind::states;
}

}  // namespace

InputKind kind_of(const fs::path& path) {
    if (fs::is_directory(path)) {
        const bool has_trajectory = fs::exists(path / "trajectory.csv");
        return !has_trajectory && has_pictures(frames_in(path)) ? InputKind::frames : InputKind::states;
    }
    if (is_standard_input(path)) return kind_of_table(path);
    if (path.extension() == ".png") return InputKind::frames;
    if (path.extension() == ".json" && is_summary_file(path)) return InputKind::summary;
    return path.extension() == ".csv" ? kind_of_table(path) : InputKind::states;
}

std::string_view name_of(InputKind kind) {
    switch (kind) {
        case InputKind::hashes: return "a list of hashes";
        case InputKind::events: return "a list of events";
        case InputKind::summary: return "a summary";
        case InputKind::frames: return "a folder of frames";
        default: return "a scene or a trajectory";
    }
}

fs::path frames_in(const fs::path& folder) { return has_pictures(folder) ? folder : folder / "frames"; }

}  // namespace tumble::tools
