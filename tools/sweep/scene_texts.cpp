#include "tools/sweep/scene_texts.hpp"

#include <system_error>

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

void write_copy(const fs::path& to, const std::string& text) {
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    if (error) throw FileError(to.parent_path(), "cannot create the folder: " + error.message());
    OutputFile output(to);
    output.write(text);
    output.commit();
}

}  // namespace

fs::path copies_in(const fs::path& sweep_folder) { return sweep_folder / "plan"; }

SceneTexts::SceneTexts(const sweep::Plan& plan, const fs::path& sweep_folder) {
    if (plan.allow_outside) return;
    folder_ = fs::absolute(plan.file).parent_path();
    copies_ = copies_in(sweep_folder);
    copy(plan.file, plan.text);
}

const std::string& SceneTexts::read(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    const auto found = texts_.find(file);
    if (found != texts_.end()) return found->second;
    new_.push_back(file);
    return texts_.emplace(file, read_file(file)).first->second;
}

void SceneTexts::copy_new() {
    const std::lock_guard lock(mutex_);
    for (; !new_.empty(); new_.pop_back())
        if (const auto text = texts_.find(new_.back()); text != texts_.end()) copy(text->first, text->second);
}

// Two processes that copy a file at once write the same.
void SceneTexts::copy(const fs::path& file, const std::string& text) const {
    if (copies_.empty()) return;
    const fs::path to = copies_ / fs::absolute(file).lexically_relative(folder_);
    if (fs::exists(to)) {
        if (read_file(to) != text)
            throw FileError(file, "has changed since the sweep began: " + to.string() + " is its copy");
        return;
    }
    write_copy(to, text);
}

void merge_copies(const fs::path& from_sweep, const fs::path& to_sweep) {
    std::error_code none;  // without copies there is nothing to merge
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(copies_in(from_sweep), none)) {
        const fs::path to = copies_in(to_sweep) / entry.path().lexically_relative(copies_in(from_sweep));
        if (entry.is_regular_file() && !entry.is_symlink() && !fs::exists(to)) write_copy(to, read_file(entry.path()));
    }
}

}  // namespace tumble::tools
