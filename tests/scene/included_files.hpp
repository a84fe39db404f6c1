// Scene files in memory that include each other, for tests.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tumble/file.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::test {

using Files = std::map<std::string, std::string>;

inline LoadOptions with_files(const Files& files) {
    LoadOptions options;
    options.read_included = [files](const std::filesystem::path& file) {
        const auto found = files.find(file.string());
        if (found == files.end()) throw FileError(file, "No such file or directory");
        return found->second;
    };
    return options;
}

// The scene "main.json" of some files, with all that it includes.
inline Scene load(const Files& files) { return parse_scene(files.at("main.json"), "main.json", with_files(files)); }

inline std::string scene_text(const std::string& keys) {
    return R"({"format": 1)" + (keys.empty() ? "" : ", " + keys) + "}";
}

inline std::string includes(const std::string& entries) { return scene_text(R"("include": [)" + entries + "]"); }

}  // namespace tumble::test
