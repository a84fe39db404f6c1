// The scene files of a sweep and their images: read once, and copied into its folder, so that it can be verified
// without the originals.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "sweep/plan/plan.hpp"
#include "sweep/store/manifest.hpp"

namespace tumble::tools {

// DIR/plan: the plan, the scene files and the images of the sweep in DIR, with their paths relative to the folder of
// the plan.
std::filesystem::path copies_in(const std::filesystem::path& sweep_folder);

// Whether DIR/plan is a folder, and no link to one elsewhere.
bool has_copies(const std::filesystem::path& sweep_folder);

// Whether a folder on the path of the copy `name` ("plan/parts/car.json") is a link, which may lead out of DIR. What is
// there is neither written nor removed.
bool is_behind_link(const std::filesystem::path& sweep_folder, const std::filesystem::path& name);

// The bytes of scene files, of their includes and of images, read once for all runs and threads.
class SceneTexts {
public:
    SceneTexts() = default;

    // Copies the plan to DIR/plan. Of a plan that may read files of other folders nothing is copied. Throws FileError.
    SceneTexts(const sweep::Plan& plan, const std::filesystem::path& sweep_folder);

    // The copies of the files that were read, without the ones that are stated.
    std::vector<sweep::StoredFile> unstated();

    // The manifest states the first `count` of them.
    void note_stated(std::size_t count);

    // Makes those of these copies that are missing or have another size, from the files that they are copies of. Throws
    // FileError, also if such a file has changed.
    void restore(const std::vector<sweep::StoredFile>& copies);

    // Throws FileError, also for a file of more than 512 MiB.
    const std::string& read(const std::filesystem::path& file);

    // Copies the files that were read since the last call. Throws FileError, also if there is a copy with another text.
    void copy_new();

private:
    void copy(const std::filesystem::path& file, const std::string& text);

    std::filesystem::path folder_{}, sweep_folder_{};  // of the plan, and DIR; empty: nothing is copied
    std::mutex mutex_;
    std::map<std::filesystem::path, std::string> texts_;
    std::vector<std::filesystem::path> new_;   // read, and not yet copied
    std::vector<sweep::StoredFile> unstated_;  // copies that the manifest does not state yet
};

// Copies to DIR/plan of one sweep those of these copies of another that it does not have; other files of the other's
// DIR/plan stay there. Throws FileError, and InputError if a checksum is another.
void merge_copies(const std::filesystem::path& from_sweep, const std::vector<sweep::StoredFile>& copies,
                  const std::filesystem::path& to_sweep);

}  // namespace tumble::tools
