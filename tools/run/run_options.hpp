// What `run` and its relatives can be told about a simulation.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>

#include "tumble/render.hpp"

namespace tumble::tools {

inline constexpr double kMaxDuration = 1e6;  // s: 11 days of simulated time

struct FrameSize {
    int width = 1280;
    int height = 720;

    double aspect_ratio() const { return static_cast<double>(width) / height; }
};

struct RunOptions {
    std::filesystem::path folder;    // receives frames/ and summary.json
    std::optional<double> duration;  // s; default: the scene's
    double frames_per_second = 60.0;
    FrameSize size;
    bool no_frames = false;
    bool force = false;                // replace what an earlier run left
    std::filesystem::path trajectory;  // empty: not written
    std::filesystem::path contacts;    // empty: not written
    std::filesystem::path hashes;      // empty: not written
    Overlay overlay;                   // what the frames show beside the shapes
};

// --size WxH
void add_size_option(CLI::App& subcommand, FrameSize& size);

// --overlay LIST
void add_overlay_option(CLI::App& subcommand, Overlay& overlay);

// -o, --duration, --fps, --size, --no-frames, --overlay, --trajectory, --contacts, --hashes, --force
void add_run_options(CLI::App& subcommand, RunOptions& options);

}  // namespace tumble::tools
