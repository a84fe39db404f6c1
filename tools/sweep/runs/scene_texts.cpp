#include "tools/sweep/runs/scene_texts.hpp"

#include <system_error>
#include <utility>

#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"
#include "tools/output/input_error.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCopies = "plan";
constexpr std::size_t kMostBytesOfCopy = std::size_t{1} << 29;  // of a file, as of a picture that is drawn

void write_copy(const fs::path& sweep_folder, const fs::path& name, const std::string& text) {
    const fs::path to = sweep_folder / name;
    if (is_behind_link(sweep_folder, name)) throw FileError(to, "is reached through a link, and is not written");
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    if (error) throw FileError(to.parent_path(), "cannot create the folder: " + error.message());
    OutputFile output(to);
    output.write(text);
    output.save_so_far();
    sweep::make_durable(output.temporary());
    output.commit();
    sweep::make_durable(to.parent_path());
}

std::string read_within_limit(const fs::path& file) {
    std::string text = read_file(file, kMostBytesOfCopy);
    if (text.size() > kMostBytesOfCopy) throw FileError(file, "is longer than 512 MiB");
    return text;
}

// Absolute, without "." and "..".
fs::path plain_path(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

}  // namespace

fs::path copies_in(const fs::path& sweep_folder) { return sweep_folder / kCopies; }

bool has_copies(const fs::path& sweep_folder) { return fs::is_directory(fs::symlink_status(copies_in(sweep_folder))); }

bool is_behind_link(const fs::path& sweep_folder, const fs::path& name) {
    for (fs::path folder = name.parent_path(); !folder.empty(); folder = folder.parent_path())
        if (fs::is_symlink(sweep_folder / folder)) return true;
    return false;
}

SceneTexts::SceneTexts(const sweep::Plan& plan, const fs::path& sweep_folder) {
    if (plan.allow_outside) return;
    folder_ = plain_path(plan.file).parent_path();
    sweep_folder_ = sweep_folder;
    copy(plan.file, plan.text);
}

const std::string& SceneTexts::read(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    const auto found = texts_.find(file);
    if (found != texts_.end()) return found->second;
    const std::string& text = texts_.emplace(file, read_within_limit(file)).first->second;
    new_.push_back(file);
    return text;
}

void SceneTexts::copy_new() {
    const std::lock_guard lock(mutex_);
    for (; !new_.empty(); new_.pop_back())
        if (const auto text = texts_.find(new_.back()); text != texts_.end()) copy(text->first, text->second);
}

std::vector<sweep::StoredFile> SceneTexts::unstated() {
    const std::lock_guard lock(mutex_);
    return unstated_;
}

void SceneTexts::note_stated(std::size_t count) {
    const std::lock_guard lock(mutex_);
    unstated_.erase(unstated_.begin(), unstated_.begin() + static_cast<std::ptrdiff_t>(count));
}

void SceneTexts::restore(const std::vector<sweep::StoredFile>& copies) {
    if (sweep_folder_.empty()) return;
    for (const sweep::StoredFile& copy : copies) {
        std::error_code error;
        if (fs::file_size(sweep_folder_ / copy.name, error) == copy.bytes && !error) continue;
        const fs::path from = folder_ / fs::path(copy.name).lexically_relative(kCopies);
        const std::string text = read_within_limit(from);
        if (sweep::hash_of(text) != copy.hash) throw FileError(from, "has changed since the sweep was made");
        write_copy(sweep_folder_, copy.name, text);
    }
}

// Two processes that copy a file at once write the same.
void SceneTexts::copy(const fs::path& file, const std::string& text) {
    if (sweep_folder_.empty()) return;
    const fs::path name = kCopies / plain_path(file).lexically_relative(folder_);
    if (const fs::path to = sweep_folder_ / name; !fs::exists(to))
        write_copy(sweep_folder_, name, text);
    else if (read_file(to) != text)
        throw FileError(file, "has changed since the sweep began: " + to.string() + " is its copy");
    unstated_.push_back({name.generic_string(), text.size(), sweep::hash_of(text)});
}

void merge_copies(const fs::path& from_sweep, const std::vector<sweep::StoredFile>& copies, const fs::path& to_sweep) {
    for (const sweep::StoredFile& copy : copies) {
        if (fs::exists(to_sweep / copy.name)) continue;
        const fs::path from = from_sweep / copy.name;
        if (is_behind_link(from_sweep, copy.name) || !fs::is_regular_file(fs::symlink_status(from)))
            throw FileError(from, "is missing, or is no file of this folder; `tumble sweep PLAN -o " +
                                      from_sweep.string() + " --check` makes it again");
        const std::string text = read_within_limit(from);
        if (sweep::hash_of(text) != copy.hash)
            throw InputError(from.string() + ": the checksum of its bytes is not that of its manifest");
        write_copy(to_sweep, copy.name, text);
    }
}

}  // namespace tumble::tools
