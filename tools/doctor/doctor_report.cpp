#include "tools/doctor/doctor_report.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "tools/machine/build_info.hpp"
#include "tools/machine/machine.hpp"
#include "tools/output/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/instruction_set.hpp"
#include "tumble/recording.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

constexpr int kFrameSide = 64;  // pixels of the frame that is encoded

// Calls the test, and keeps how long it took.
template <class Test>
Finding timed(Test&& test) {
    const auto start = std::chrono::steady_clock::now();
    Finding finding = test();
    finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return finding;
}

std::string joined_lines(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

Finding find_back_end(const BackendName& backend) {
    const BackendCheck check = check_backend(backend.backend);
    return {.name = std::string(backend.name),
            .works = check.works,
            .detail = check.works ? check.renderer + ", OpenGL " + check.version : joined_lines(check.error),
            .package = backend.backend == RenderBackend::egl ? "libegl1 libgl1-mesa-dri" : "libosmesa6"};
}

std::vector<Finding> find_fonts() {
    const FontFiles files = find_font_files();
    const auto font = [](const char* name, const std::string& file, const char* use, const char* package) {
        return Finding{.name = name, .works = !file.empty(), .detail = file.empty() ? use : file, .package = package};
    };
    return {font("text", files.text, "frames of 400 x 225 pixels or more need it for their text", "fonts-dejavu-core"),
            font("wide", files.wide, "characters of Chinese and other scripts are boxes", "fonts-noto-cjk")};
}

// Encodes one white frame.
Finding find_encoder(const std::string& format) {
    Finding finding{.name = format, .package = "ffmpeg"};
    try {
        const TemporaryFolder folder("doctor");
        const std::filesystem::path file = folder.path() / ("frame." + format);
        VideoWriter writer(file, {.format = *video_format_of(file), .width = kFrameSide, .height = kFrameSide});
        writer.write(
            {kFrameSide, kFrameSide, std::vector<std::uint8_t>(std::size_t{4} * kFrameSide * kFrameSide, 255)});
        const std::uint64_t bytes = writer.finish();
        finding.works = bytes > 0;
        finding.detail = "one frame of " + std::to_string(bytes) + " bytes";
    } catch (const RenderError& error) {
        finding.detail = joined_lines(error.what());
    } catch (const std::runtime_error& error) {
        finding.detail = joined_lines(error.what());
        finding.package.clear();  // the file system fails, not the encoder
    }
    return finding;
}

bool is_working(const Finding& finding) { return finding.works; }

std::string milliseconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, " (%.0f ms)", 1e3 * seconds);
    return text;
}

void append_findings(std::string& text, const std::string& title, const std::vector<Finding>& findings) {
    text += title + "\n";
    for (const Finding& finding : findings) {
        text += std::string("  ") + (finding.works ? "ok     " : "fails  ") + finding.name +
                std::string(finding.name.size() < 8 ? 8 - finding.name.size() : 1, ' ') + finding.detail;
        if (finding.works && finding.seconds > 0.0) text += milliseconds(finding.seconds);
        text += "\n";
        if (!finding.works && !finding.package.empty())
            text += "         install it by: apt-get install " + finding.package + "\n";
    }
}

void write_findings(JsonWriter& json, const char* key, const std::vector<Finding>& findings) {
    json.key(key).open_array();
    for (const Finding& finding : findings) {
        json.open_object().member("name", finding.name).member("works", finding.works);
        json.member("detail", finding.detail).member("package", finding.package);
        json.member("seconds", finding.seconds).close_object();
    }
    json.close_array();
}

}  // namespace

bool DoctorReport::frames() const { return std::ranges::any_of(back_ends, is_working); }
bool DoctorReport::text() const { return !fonts.empty() && fonts.front().works; }
bool DoctorReport::videos() const { return std::ranges::all_of(encoders, is_working); }

DoctorReport examine_machine() {
    DoctorReport report;
    for (const BackendName& backend : kBackends)
        if (backend.backend != RenderBackend::automatic)
            report.back_ends.push_back(timed([&] { return find_back_end(backend); }));
    report.fonts = find_fonts();
    for (const char* const format : {"mp4", "webm", "gif", "apng"})
        report.encoders.push_back(timed([&] { return find_encoder(format); }));
    return report;
}

std::string to_text(const DoctorReport& report) {
    std::string sets;
    for (const std::string& set : instruction_sets()) sets += (sets.empty() ? "" : ", ") + set;
    std::string text = "tumble " + version() + ", " + compiler_name() + ", " + build_type() + "\n";
    text += "processor\n  " + processor_name() + ", " + std::to_string(std::thread::hardware_concurrency()) +
            " threads\n  uses " + instruction_set() + ", of " + sets + "\n";
    append_findings(text, "frames: each back end draws a triangle; one is enough", report.back_ends);
    append_findings(text, "fonts", report.fonts);
    append_findings(text, "videos: ffmpeg encodes a frame in each format", report.encoders);
    const auto yes = [](bool works) { return works ? "yes" : "no"; };
    return text + "works: frames " + yes(report.frames()) + ", text in frames " + yes(report.text()) + ", videos " +
           yes(report.videos()) + "\n";
}

void write_report(JsonWriter& json, const DoctorReport& report) {
    json.open_object().member("version", version()).key("machine");
    write_machine(json);
    json.member("instruction_sets", instruction_sets());
    write_findings(json, "back_ends", report.back_ends);
    write_findings(json, "fonts", report.fonts);
    write_findings(json, "encoders", report.encoders);
    json.member("frames", report.frames()).member("text", report.text()).member("videos", report.videos());
    json.close_object();
}

}  // namespace tumble::tools
