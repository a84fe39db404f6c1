// What ffprobe says of a video.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"

namespace tumble::test {

// The streams and the format of a video, with counted frames.
inline nlohmann::json probe(const std::filesystem::path& file) {
    const Answer answer =
        run({"ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "-of", "json", file.string()});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    REQUIRE_MESSAGE(answer.err.empty(), answer.err);
    return nlohmann::json::parse(answer.out);
}

inline double number_in(const nlohmann::json& text) { return std::stod(text.get<std::string>()); }

// The processes of that name with the video among their arguments.
inline std::vector<int> processes_of(const std::string& name, const std::filesystem::path& video) {
    std::vector<int> ids;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string command = read_text(entry.path() / "cmdline");
        if (command.starts_with(name) && command.find(video.string()) != std::string::npos)
            ids.push_back(std::stoi(entry.path().filename().string()));
    }
    return ids;
}

// Waits until ffmpeg encodes this video, and returns its id; 0 if that never happens.
inline int wait_for_encoder(const std::filesystem::path& video, const Process& process) {
    for (int tries = 0; tries < 6000 && process.is_running(); ++tries) {
        if (const std::vector<int> ids = processes_of("ffmpeg", video); !ids.empty()) return ids.front();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return 0;
}

// Waits until the encoder has read so much, frames that the other process has drawn, for at most 120 s.
inline bool wait_for_frames(int encoder, std::uint64_t bytes) {
    for (int tries = 0; tries < 24000; ++tries) {
        std::ifstream counters("/proc/" + std::to_string(encoder) + "/io");
        std::string name;
        std::uint64_t read = 0;
        if (!(counters >> name >> read)) return false;
        if (read >= bytes) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

}  // namespace tumble::test
