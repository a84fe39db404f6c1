#include "tools/cli/output_path.hpp"

#include <CLI/CLI.hpp>

#include <set>
#include <string>
#include <system_error>

#include "tools/cli/console.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

// Refuses the extensions of other formats, in letters of either case: "ADVICE, not NAME" and `more`.
CLI::Validator name_without(const std::set<std::string>& extensions, const std::string& advice,
                            const std::string& more) {
    const auto check = [=](const std::string& name) {
        const std::string extension = CLI::detail::to_lower(fs::path(name).extension().string());
        return extensions.contains(extension) ? advice + ", not " + name + more : "";
    };
    return {check, ""};
}

}  // namespace

bool is_standard_output(const fs::path& file) { return file == "/dev/stdout"; }

CLI::Validator file_name() {
    const auto check = [](const std::string& file) {
        return file.empty() ? "needs the name of a file, got an empty one" : "";
    };
    return {check, ""};
}

CLI::Option& allow_standard_output(CLI::Option& option) {
    option.transform([](const std::string& file) {  // the name of the option precedes the message
        if (file != "-" && !is_standard_output(file)) return file;
        if (!give_output_to_file()) throw CLI::ValidationError("names standard output, which another option names too");
        return std::string("/dev/stdout");
    });
    option.check(file_name());
    return option;
}

CLI::Validator page_name() {
    return name_without({".png", ".jpg", ".jpeg", ".gif", ".svg", ".pdf", ".mp4", ".webm", ".apng", ".csv", ".json",
                         ".xml", ".txt", ".md"},
                        "pages are HTML: choose a name that ends in .html", "");
}

CLI::Validator table_name() {
    return name_without({".h5", ".hdf5", ".npy", ".npz", ".json", ".jsonl", ".parquet", ".xlsx"},
                        "tables are CSV: choose a name that ends in .csv",
                        "; a sweep writes trajectories as HDF5 and npy");
}

CLI::Validator folder_name() {
    const auto check = [](const std::string& folder) -> std::string {
        if (folder.empty()) return "needs the name of a folder, got an empty one";
        return folder == "-" || is_standard_output(folder) ? "names a folder, which standard output is not" : "";
    };
    return {check, ""};
}

fs::path place_of(const fs::path& file) {
    return fs::weakly_canonical(fs::absolute(file).parent_path()) / file.filename();
}

void require_different_names(std::span<const fs::path> files) {
    std::set<fs::path> names;
    for (const fs::path& file : files)
        if (!file.empty() && !is_standard_output(file) && !names.insert(place_of(file)).second)
            throw CLI::ValidationError(file.string(), "names two output files; give each its own name");
}

void refuse_to_overwrite(const fs::path& file, bool force) {
    if (is_standard_output(file)) return;
    std::error_code ignored;
    const fs::file_status target = fs::status(file, ignored);
    if (fs::is_directory(target)) throw FileError(file, "is a folder; choose the name of a file");
    // Files are renamed into place, which would replace the device itself.
    if (fs::is_other(target)) throw FileError(file, "is a device or a pipe; choose the name of a file");
    if (!force && fs::exists(fs::symlink_status(file, ignored)))
        throw FileError(file, "already exists; choose another name, or replace it with --force");
}

void create_folder_of(const fs::path& file) {
    if (!file.has_parent_path() || is_standard_output(file)) return;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw FileError(file.parent_path(), "cannot create the folder: " + error.message());
}

OutputFile open_output(const fs::path& file, bool force) {
    refuse_to_overwrite(file, force);
    create_folder_of(file);
    return OutputFile(file);
}

void write_file(const fs::path& file, std::string_view text, bool force) {
    OutputFile output = open_output(file, force);
    output.write(text);
    output.commit();
}

}  // namespace tumble::tools
