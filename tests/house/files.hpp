// The files of the project by their folders and endings.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "house/walls.hpp"

namespace tumble::test {

inline bool has_ending(const std::filesystem::path& file, std::initializer_list<std::string_view> endings) {
    return std::ranges::find(endings, file.extension().string()) != endings.end();
}

inline bool is_source(const std::filesystem::path& file) { return has_ending(file, {".cpp", ".hpp"}); }

// The files with these endings below folders of the project.
inline std::vector<std::filesystem::path> files_below(std::initializer_list<std::string_view> folders,
                                                      std::initializer_list<std::string_view> endings) {
    std::vector<std::filesystem::path> files;
    for (const std::string_view folder : folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(kProject / folder))
            if (has_ending(entry.path(), endings)) files.push_back(entry.path());
    return files;
}

inline std::string text_in(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// "src/scene/json/text.cpp".
inline std::string name_in_project(const std::filesystem::path& file) {
    return std::filesystem::relative(file, kProject).generic_string();
}

}  // namespace tumble::test
