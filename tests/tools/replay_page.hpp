// Makes replay pages, and asks them in headless Chromium.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

namespace tumble::test {

// The lines of replay_browser.py.
inline std::vector<nlohmann::json> browse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"/usr/bin/python3", TUMBLE_SOURCE_DIR "/tests/tools/replay_browser.py"});
    const Answer answer = run(arguments);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    std::vector<nlohmann::json> values;
    std::istringstream lines(answer.out);
    for (std::string line; std::getline(lines, line);) values.push_back(nlohmann::json::parse(line));
    return values;
}

// Runs a scene without frames and returns the path of its page.
inline std::string make_page(const Folder& folder, const std::string& scene, std::vector<std::string> more = {}) {
    std::string page = (folder / (std::filesystem::path(scene).stem().string() + ".html")).string();
    std::vector<std::string> arguments{"run",      scene, "--no-frames", "--force", "-o", (folder / "out").string(),
                                       "--replay", page};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Answer answer = run_tumble(arguments);
    REQUIRE_MESSAGE(answer.code == 0, scene << ": " << answer.err);
    return page;
}

}  // namespace tumble::test
