// The scenes that the project ships.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace tumble::test {

inline std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator(std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes"))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace tumble::test
