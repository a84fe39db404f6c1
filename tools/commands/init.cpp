// `tumble init`: writes a project folder for scenes that a CI service checks.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/shell_word.hpp"
#include "tools/commands/commands.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/scene/hash_update.hpp"
#include "tools/scene/project_files.hpp"
#include "tools/scene/scene_check.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

std::string project_name(const fs::path& folder) {
    const fs::path last = fs::absolute(folder / "").lexically_normal().parent_path().filename();
    return last.empty() ? "physics" : last.string();
}

// Runs the scene and writes its hash into its claim.
void write_hash(const fs::path& scene) {
    SceneCheck check = check_scene_file(scene.string(), {});
    if (!check.error.empty()) throw FileError(scene, check.error);
    update_hashes(check);
}

void refuse_existing(const fs::path& file) {
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file, ignored)))
        throw FileError(file, "already exists, and no file is replaced; choose another name");
}

ExitCode init(const Command& command, const fs::path& folder) {
    const std::vector<ProjectFile> files = project_files(project_name(folder));
    for (const ProjectFile& file : files) refuse_existing(folder / file.path);
    std::vector<std::string> paths;
    for (const ProjectFile& file : files) {
        write_file(folder / file.path, file.text, false);
        if (file.text.find("\"state_hash\": \"0") != std::string::npos) write_hash(folder / file.path);
        paths.push_back(file.path);
    }
    if (command.json) {
        JsonWriter json;
        json.open_object().member("folder", folder.string()).member("files", paths).close_object();
        write_output(json.text() + "\n");
        return ExitCode::ok;
    }
    for (const std::string& path : paths) write_report((folder / path).string() + "\n");
    narrate_progress("next: cd " + shell_word(folder.string()) + " && make check\n");
    return ExitCode::ok;
}

}  // namespace

void add_init(CLI::App& app, Command& command) {
    const auto folder = std::make_shared<fs::path>();
    CLI::App& app_init =
        add_subcommand(app, command, "init", "Make a project folder: scenes with claims, a Makefile, CI workflows");
    app_init.add_option("NAME", *folder, "Folder to make; files that exist are not replaced")
        ->required()
        ->check(folder_name());
    app_init.callback([&command, folder] { command.action = [&command, folder] { return init(command, *folder); }; });
}

}  // namespace tumble::tools
