// A folder with a plan, its scene and the results of its sweeps, and what tests ask of them.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tools/process.hpp"

namespace tumble::test {

inline constexpr const char* kScene = R"({"format": 1, "world": {"duration": 0.5},
  "bodies": [{"name": "floor", "type": "static", "shapes": [{"box": {"size": [20, 1]}}]},
             {"name": "ball", "position": [0, 2], "velocity": [0, 0], "shapes": [{"circle": {"radius": 0.5}}]}],
  "expect": [{"that": "ball.y > 0.9"}]})";

inline constexpr const char* kPlan = R"({"format": 1, "scene": "scene.json", "runs": 200, "shard_runs": 10,
  "parameters": [{"name": "height", "set": "/bodies/ball/position/1", "range": [1.2, 4]},
                 {"name": "speed", "set": ["/bodies/ball/velocity/0"], "list": [-1, 0, 1]}],
  "measures": [{"name": "x", "value": "ball.x"}, {"name": "double_speed", "value": "2 * speed"}],
  "write": {"trajectory": {"every": 5}, "events": true, "summary": true}})";

// A folder with a scene, a plan and the names of results.
struct Sweeps {
    Folder folder;
    std::string plan;

    explicit Sweeps(const std::string& text = kPlan) {
        folder.write("scene.json", kScene);
        plan = folder.write("plan.json", text);
    }
    std::string at(const std::string& name) const { return (folder / name).string(); }
    std::vector<std::string> arguments(const std::string& name, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"sweep", plan, "-o", at(name)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Answer sweep(const std::string& name, const std::vector<std::string>& more = {}) const {
        return run_tumble(arguments(name, more));
    }
};

inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const std::filesystem::directory_entry& entry : std::filesystem::recursive_directory_iterator(folder))
        files[std::filesystem::relative(entry.path(), folder).string()] =
            entry.is_directory() ? "folder" : read_text(entry.path());
    return files;
}

inline bool are_equal(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto in_a = files_of(a), in_b = files_of(b);
    for (const auto& [name, bytes] : in_a)
        if (!in_b.contains(name) || in_b.at(name) != bytes) MESSAGE(name << " differs or is missing in the second");
    for (const auto& [name, bytes] : in_b)
        if (!in_a.contains(name)) MESSAGE(name << " is in the second only");
    return in_a == in_b;
}

// The cells of a line of runs.csv.
inline std::vector<std::string> row(const std::filesystem::path& folder, std::size_t line) {
    std::istringstream text(read_text(folder / "runs.csv"));
    std::string found;
    for (std::size_t i = 0; i <= line; ++i) std::getline(text, found);
    std::vector<std::string> cells;
    std::istringstream parts(found);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    return cells;
}

inline void flip_byte(const std::filesystem::path& file, std::streamoff at) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const int byte = stream.get();
    stream.seekp(at);
    stream.put(static_cast<char>(byte ^ 1));
}

}  // namespace tumble::test
