#include "tools/scene/data_paths.hpp"

#include <algorithm>
#include <system_error>

#include "tools/output/standard_input.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

// The folder above that of the binary: the prefix of an installation, or the build folder.
fs::path prefix() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
}

// In a build folder this is a link to the scenes of the sources.
fs::path scenes_of_prefix() { return prefix() / "share" / "tumble" / "scenes"; }

bool runs_in_build_folder() {
    std::error_code ignored;
    return fs::exists(prefix() / "CMakeCache.txt", ignored);
}

bool is_scene(const fs::path& file) { return file.extension() == ".json" && file.filename() != "scene.schema.json"; }

}  // namespace

fs::path find_scenes_folder() {
    std::error_code ignored;
    fs::path folder = fs::canonical(scenes_of_prefix(), ignored);
    if (folder.empty()) throw FileError(scenes_of_prefix(), "the shipped scenes are missing");
    return folder;
}

std::vector<fs::path> find_scenes() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(find_scenes_folder()))
        if (is_scene(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

fs::path find_scene(const std::string& name) {
    if (is_standard_input(name)) return name;
    for (const fs::path& file : find_scenes())
        if (file.stem() == name) return file;
    if (!fs::exists(name) && fs::path(name).filename() == name && !fs::path(name).has_extension())
        throw FileError(name, "no such file, and no shipped scene of this name ('tumble demo --list' lists them)");
    return name;
}

fs::path demo_folder() { return runs_in_build_folder() ? prefix() / "demo" : fs::path("out") / "demo"; }

std::string command_to_type() {
    if (!runs_in_build_folder()) return "tumble";
    std::error_code ignored;
    const fs::path source = fs::canonical(scenes_of_prefix(), ignored).parent_path();
    if (fs::equivalent(source, fs::current_path(ignored), ignored)) return "./tools/run.sh";
    return (source / "tools" / "run.sh").string();
}

}  // namespace tumble::tools
