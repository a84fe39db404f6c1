#include "tools/sweep/runs/scene_texts.hpp"

#include <algorithm>
#include <system_error>

#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostBytesOfCopy = std::size_t{1} << 29;  // of a file, as of a picture that is drawn

void write_copy(const fs::path& to, const std::string& text) {
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

fs::path copies_in(const fs::path& sweep_folder) { return sweep_folder / "plan"; }

bool has_copies(const fs::path& sweep_folder) { return fs::is_directory(fs::symlink_status(copies_in(sweep_folder))); }

SceneTexts::SceneTexts(const sweep::Plan& plan, const fs::path& sweep_folder) {
    if (plan.allow_outside) return;
    folder_ = plain_path(plan.file).parent_path();
    copies_ = copies_in(sweep_folder);
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

void SceneTexts::restore(const std::vector<sweep::StoredFile>& copies) {
    if (copies_.empty()) return;
    for (const sweep::StoredFile& copy : copies) {
        const fs::path to = copies_.parent_path() / copy.name;
        std::error_code error;
        if (fs::file_size(to, error) == copy.bytes && !error) continue;
        const fs::path from = folder_ / to.lexically_relative(copies_);
        const std::string text = read_within_limit(from);
        if (sweep::hash_of(text) != copy.hash) throw FileError(from, "has changed since the sweep was made");
        write_copy(to, text);
    }
}

// Two processes that copy a file at once write the same.
void SceneTexts::copy(const fs::path& file, const std::string& text) const {
    if (copies_.empty()) return;
    const fs::path to = copies_ / plain_path(file).lexically_relative(folder_);
    if (fs::exists(to)) {
        if (read_file(to) != text)
            throw FileError(file, "has changed since the sweep began: " + to.string() + " is its copy");
        return;
    }
    write_copy(to, text);
}

std::vector<sweep::StoredFile> stored_copies(const fs::path& sweep_folder) {
    std::vector<sweep::StoredFile> copies;
    if (!has_copies(sweep_folder)) return copies;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(copies_in(sweep_folder)))
        if (entry.is_regular_file() && !entry.is_symlink())
            copies.push_back(
                sweep::read_stored_file(sweep_folder, entry.path().lexically_relative(sweep_folder).generic_string()));
    std::ranges::sort(copies, {}, &sweep::StoredFile::name);
    return copies;
}

void merge_copies(const fs::path& from_sweep, const fs::path& to_sweep) {
    if (!has_copies(from_sweep)) return;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(copies_in(from_sweep))) {
        const fs::path to = copies_in(to_sweep) / entry.path().lexically_relative(copies_in(from_sweep));
        if (entry.is_regular_file() && !entry.is_symlink() && !fs::exists(to))
            write_copy(to, read_within_limit(entry.path()));
    }
}

}  // namespace tumble::tools
