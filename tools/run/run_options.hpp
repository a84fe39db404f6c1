// The options of a run: what to simulate, what to draw, which files to write.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/plot/frame_plots.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tumble/render.hpp"

namespace CLI {
class App;
}

namespace tumble::tools {

inline constexpr double kMaxDuration = 1e6;  // s: 11 days of simulated time

struct FrameSize {
    int width = 1280;
    int height = 720;

    bool is_even() const { return width % 2 == 0 && height % 2 == 0; }
    double aspect_ratio() const { return static_cast<double>(width) / height; }
};

struct RunOptions {
    std::filesystem::path folder;    // of frames/, summary.json and events.csv
    std::optional<double> duration;  // s; without it the scene's
    double frames_per_second = 60.0;
    std::vector<SlowMotion> slow;  // in order of time, without overlap
    FrameSize size;
    bool no_frames = false;
    bool force = false;                // replace the results of an earlier run
    std::optional<double> checkpoint;  // s of wall clock between checkpoints, 0: after each step; without it none
    bool resume = false;               // continue the run in the folder from its checkpoint
    std::filesystem::path trajectory;  // empty: not written
    std::filesystem::path contacts;    // empty: not written
    std::filesystem::path hashes;      // empty: not written
    std::filesystem::path replay;      // empty: not written
    std::filesystem::path video;       // empty: not written
    std::filesystem::path raw_video;   // empty: not written
    std::filesystem::path report;      // of health; empty: not written
    bool fail_on_findings = false;     // a report with findings ends with exit code 7
    int threads = 1;                   // that make a step; 0: one for each processor
    bool no_replay_contacts = false;   // leave the contact points out of the replay
    Overlay overlay;                   // drawn over the shapes
    std::vector<std::string> plot;     // expressions to plot below the frames
    RenderBackend renderer = RenderBackend::automatic;
    int jobs = 1;              // threads that draw frames, 1 to 256
    bool masks = false;        // write the label of the body that each pixel shows
    bool depth_order = false;  // write the order of drawing, and what covers what
    bool boxes = false;        // write boxes, outlines and key points of bodies

    bool draws() const { return !no_frames || !video.empty() || !raw_video.empty(); }
    FrameSize whole_size() const;                   // of a frame with its plots
    FramePlots plots_of(const Scene& scene) const;  // below the frames
    bool labels() const { return masks || depth_order || boxes; }
};

// --size WxH
void add_size_option(CLI::App& subcommand, FrameSize& size, const std::string& shown_default = "1280x720");

// --overlay LIST, --hide LIST, --theme NAME
void add_overlay_option(CLI::App& subcommand, Overlay& overlay);

// --renderer NAME
void add_renderer_option(CLI::App& subcommand, RenderBackend& renderer);

// --threads N
void add_threads_option(CLI::App& subcommand, int& threads);

// -o, --duration, --fps, --slow, --size, --no-frames, --overlay, --hide, --theme, --plot, --renderer, --trajectory,
// --contacts, --hashes, --replay, --report, --fail-on-findings, --video, --raw-video, --masks, --depth-order, --boxes,
// --checkpoint, --resume, --threads, --jobs, --force
void add_run_options(CLI::App& subcommand, RunOptions& options);

}  // namespace tumble::tools
