#include "tools/run/run_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <locale>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "tools/cli/command.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/cli/validators.hpp"

namespace tumble::tools {

namespace {

constexpr double kMaxRate = 1e5;      // frames/s
constexpr double kLeastSpeed = 1e-3;  // of slow motion

bool parse_side(std::string_view text, int& pixels) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    return error == std::errc{} && end == text.data() + text.size() && pixels >= kSmallestFrame &&
           pixels <= kLargestFrame;
}

FrameSize parse_size(const std::string& text) {
    FrameSize size;
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos && parse_side(std::string_view(text).substr(0, cross), size.width) &&
        parse_side(std::string_view(text).substr(cross + 1), size.height))
        return size;
    throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, each from " + std::to_string(kSmallestFrame) + " to " +
                                             std::to_string(kLargestFrame) + " pixels, got " + text);
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string names_of(std::span<const OverlayPart> parts) {
    std::string names;
    for (const OverlayPart& part : parts) names += (names.empty() ? "" : ",") + std::string(part.name);
    return names;
}

// "2:2.5:0.1", from a time to a time at a speed.
SlowMotion parse_slow(const std::string& text) {
    SlowMotion part;
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    char first = 0, second = 0;
    const bool is_read = static_cast<bool>(in >> part.from >> first >> part.to >> second >> part.speed);
    const bool is_whole = is_read && first == ':' && second == ':' && in.peek() == std::char_traits<char>::eof();
    if (is_whole && part.from >= 0.0 && part.to > part.from && part.to <= kMaxDuration && part.speed >= kLeastSpeed &&
        part.speed <= 1.0)
        return part;
    throw CLI::ValidationError("--slow",
                               "expected FROM:TO:SPEED, two times in s and a speed from 0.001 to 1, got " + text);
}

void set_slow(std::vector<SlowMotion>& slow, const std::vector<std::string>& texts) {
    slow.clear();
    for (const std::string& text : texts) slow.push_back(parse_slow(text));
    std::ranges::sort(slow, {}, &SlowMotion::from);
    for (std::size_t i = 1; i < slow.size(); ++i)
        if (slow[i].from < slow[i - 1].to)
            throw CLI::ValidationError("--slow", "the times of two slow motions overlap");
}

// Sets the listed parts to `shown`.
void set_parts(Overlay& overlay, const std::string& option, std::span<const OverlayPart> parts, const std::string& text,
               bool shown) {
    std::istringstream list(text);
    for (std::string name; std::getline(list, name, ',');) {
        std::erase(name, ' ');
        if (name == "all") {
            for (const OverlayPart& part : parts) overlay.*part.member = shown;
            continue;
        }
        const auto found = std::ranges::find(parts, name, &OverlayPart::name);
        if (found == parts.end())
            throw CLI::ValidationError(
                option, "unknown part '" + name + "'; expected " + names_of(parts) + " or all, separated by commas");
        overlay.*found->member = shown;
    }
}

void add_tables(CLI::App& subcommand, RunOptions& options) {
    const auto add_table = [&](const char* name, std::filesystem::path& file, const char* description) {
        allow_standard_output(*subcommand.add_option(name, file, description)->type_name("F.csv")).check(table_name());
    };
    add_table("--trajectory", options.trajectory, "Write the pose and velocity of each body after each step");
    add_table("--contacts", options.contacts, "Write every contact point after each step");
    add_table("--hashes", options.hashes, "Write the state hash after each step");
}

}  // namespace

FrameSize RunOptions::whole_size() const { return {size.width, size.height + height_of_plots(plot.size())}; }

FramePlots RunOptions::plots_of(const Scene& scene) const {
    const Theme theme = overlay.theme.value_or(scene.camera.style.theme);
    return {plot, size.width, size.height, duration, is_dark(theme), renderer};
}

void add_size_option(CLI::App& subcommand, FrameSize& size, const std::string& shown_default) {
    subcommand
        .add_option_function<std::string>(
            "--size", [&size](const std::string& text) { size = parse_size(text); },
            "Width and height of the frames in pixels")
        ->type_name("WxH")
        ->default_str(shown_default);
}

void add_overlay_option(CLI::App& subcommand, Overlay& overlay) {
    subcommand
        .add_option_function<std::string>(
            "--overlay",
            [&overlay](const std::string& text) { set_parts(overlay, "--overlay", kOverlayParts, text, true); },
            "Also draw: " + names_of(kOverlayParts) + ", or all")
        ->type_name("LIST");
    subcommand
        .add_option_function<std::string>(
            "--hide", [&overlay](const std::string& text) { set_parts(overlay, "--hide", kFrameParts, text, false); },
            "Leave out: " + names_of(kFrameParts) + ", or all")
        ->type_name("LIST");
    std::vector<std::string> themes;
    for (const ThemeName& theme : kThemes) themes.emplace_back(theme.name);
    subcommand
        .add_option_function<std::string>(
            "--theme",
            [&overlay](const std::string& name) {
                overlay.theme = std::ranges::find(kThemes, name, &ThemeName::name)->theme;
            },
            "Colours: " + joined(themes) + "; default: those of the scene")
        ->type_name("NAME")
        ->check(CLI::IsMember(themes));
}

void add_renderer_option(CLI::App& subcommand, RenderBackend& renderer) {
    std::vector<std::string> names;
    for (const BackendName& backend : kBackends) names.emplace_back(backend.name);
    subcommand
        .add_option_function<std::string>(
            "--renderer",
            [&renderer](const std::string& name) {
                renderer = std::ranges::find(kBackends, name, &BackendName::name)->backend;
            },
            "What draws the frames: osmesa, egl, or auto, the first of them that works")
        ->type_name("NAME")
        ->default_str("auto")
        ->check(CLI::IsMember(names));
}

void add_threads_option(CLI::App& subcommand, int& threads) {
    subcommand
        .add_option("--threads", threads,
                    "Threads that make a step; 0: one for each processor. Results do not depend on it")
        ->capture_default_str()
        ->check(whole_number_from_to(0, 256));
}

void add_run_options(CLI::App& subcommand, RunOptions& options) {
    subcommand.add_option("-o,--output", options.folder, "Folder for the results; default out/<scene name>")
        ->type_name("DIR")
        ->check(folder_name());
    subcommand.add_option("--duration", options.duration, "Simulated time in seconds; default: that of the scene")
        ->type_name("S")
        ->check(number_from_to(0.0, kMaxDuration));
    subcommand.add_option("--fps", options.frames_per_second, "Frames per simulated second")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_from_to(1e-3, kMaxRate));
    subcommand
        .add_option_function<std::vector<std::string>>(
            "--slow", [&options](const std::vector<std::string>& texts) { set_slow(options.slow, texts); },
            "Show this part of the simulated time at this speed: 2:2.5:0.1; repeatable")
        ->type_name("FROM:TO:SPEED")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_size_option(subcommand, options.size);
    subcommand.add_flag("--no-frames", options.no_frames, "Simulate without drawing frames");
    add_overlay_option(subcommand, options.overlay);
    CLI::Option* const plot =
        subcommand
            .add_option("--plot", options.plot,
                        "Plot these expressions below the frames, with the time of each: ball.y, energy, ...")
            ->type_name("EXPRESSION");
    add_renderer_option(subcommand, options.renderer);
    add_tables(subcommand, options);
    const auto add_page = [&](const char* name, std::filesystem::path& file, const char* description) {
        return allow_standard_output(*subcommand.add_option(name, file, description)->type_name("F.html"))
            .check(page_name());
    };
    CLI::Option* const replay = add_page("--replay", options.replay, "Write a page that plays the run in a browser");
    subcommand
        .add_flag("--no-replay-contacts", options.no_replay_contacts,
                  "Leave the contact points out of the replay: a page of half the size")
        ->needs(replay);
    CLI::Option* const report =
        add_page("--report", options.report, "Write a page that tells what is wrong with the run");
    subcommand
        .add_flag("--fail-on-findings", options.fail_on_findings, "End with exit code 7 if the report has findings")
        ->needs(report);
    CLI::Option* const video = &allow_standard_output(
        *subcommand
             .add_option("--video", options.video,
                         "Write a video: .mp4, .webm, .gif or .apng; - is an MP4 on standard output; needs ffmpeg")
             ->type_name("F"));
    CLI::Option* const raw_video = &allow_standard_output(
        *subcommand
             .add_option(
                 "--raw-video", options.raw_video,
                 "Write the frames without compression or header: rgb24, rows from the top; - is standard output")
             ->type_name("F"));
    CLI::Option* const masks =
        subcommand.add_flag("--masks", options.masks, "Write the body that each pixel shows: PNG files of 16 bits");
    CLI::Option* const depth_order =
        subcommand.add_flag("--depth-order", options.depth_order, "Write which shape covers which in each frame");
    CLI::Option* const boxes = subcommand.add_flag(
        "--boxes", options.boxes, "Write boxes, outlines, visibility and joints of all bodies in the format of COCO");
    subcommand
        .add_option("--checkpoint", options.checkpoint,
                    "Save the run after each S seconds of wall clock, and when it is interrupted")
        ->type_name("S")
        ->check(number_from_to(0.0, kMaxDuration))
        ->excludes(plot, replay, report, video, raw_video, masks, depth_order, boxes);
    CLI::Option* const resume =
        subcommand.add_flag("--resume", options.resume, "Continue the run in the folder from its checkpoint")
            ->excludes(plot, replay, report, video, raw_video, masks, depth_order, boxes);
    add_threads_option(subcommand, options.threads);
    subcommand.add_option("-j,--jobs", options.jobs, "Threads that draw frames. Frames do not depend on it")
        ->capture_default_str()
        ->check(whole_number_from_to(1, 256));
    subcommand.add_flag("--force", options.force, "Replace the results of an earlier run")->excludes(resume);
    subcommand.parse_complete_callback([&subcommand] {
        if (subcommand.count("--video") + subcommand.count("--raw-video") > 0) return;
        warn_of_unused(subcommand, {"--overlay", "--hide", "--plot", "--jobs"}, "--no-frames");
        if (subcommand.count("--replay") == 0) warn_of_unused(subcommand, {"--theme"}, "--no-frames");
        if (subcommand.count("--report") == 0) warn_of_unused(subcommand, {"--renderer"}, "--no-frames");
        if (subcommand.count("--masks") + subcommand.count("--depth-order") + subcommand.count("--boxes") > 0) return;
        warn_of_unused(subcommand, {"--fps", "--slow"}, "--no-frames");
        if (subcommand.count("--replay") == 0) warn_of_unused(subcommand, {"--size"}, "--no-frames");
    });
}

}  // namespace tumble::tools
