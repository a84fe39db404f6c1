// Videos written by the library.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

Image grey(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), 128)};
}

VideoSettings small_video() { return {.format = VideoFormat::mp4, .width = 64, .height = 36}; }

}  // namespace

TEST_CASE("the format of a video is that of its extension, in any case") {
    CHECK(video_format_of("a/b.mp4") == VideoFormat::mp4);
    CHECK(video_format_of("a.WebM") == VideoFormat::webm);
    CHECK(video_format_of("a.mp4.gif") == VideoFormat::gif);
    CHECK(video_format_of("a.apng") == VideoFormat::apng);
    CHECK(!video_format_of("a.png").has_value());
    CHECK(!video_format_of("mp4").has_value());
}

TEST_CASE("a video appears when it is finished, and not at all without that") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "v.mp4";
    {
        VideoWriter writer(file, small_video());
        for (int i = 0; i < 3; ++i) writer.write(grey(64, 36));
        CHECK(!fs::exists(file));
        const std::uint64_t size = writer.finish();
        CHECK(size == fs::file_size(file));
    }
    fs::remove(file);
    {
        VideoWriter writer(file, small_video());
        writer.write(grey(64, 36));
    }
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a frame of another size and a folder that is missing are errors") {
    const TemporaryFolder folder;
    VideoWriter writer(folder.path / "v.mp4", small_video());
    CHECK_THROWS_AS(writer.write(grey(36, 64)), std::invalid_argument);
    CHECK_THROWS_AS(VideoWriter(folder.path / "no/v.mp4", small_video()), FileError);
}

TEST_CASE("an encoder that refuses its settings is an error with its last line, from each call") {
    const TemporaryFolder folder;
    VideoSettings odd = small_video();
    odd.width = 63;  // yuv420p has one colour for two columns
    // A child of the program itself, for which the writer must not wait.
    const pid_t child = fork();
    if (child == 0) _exit(7);
    {
        VideoWriter writer(folder.path / "v.mp4", odd);
        const std::string begin = (folder.path / "v.mp4").string() + ": ffmpeg failed with exit code ";
        const auto error_of = [&](const auto& call) -> std::string {
            try {
                call();
            } catch (const RenderError& error) {
                return error.what();
            }
            return "no error";
        };
        const std::string first = error_of([&] {
            for (int i = 0; i < 10000; ++i) writer.write(grey(63, 36));
        });
        CHECK_MESSAGE(first.starts_with(begin), first);
        CHECK_MESSAGE(first.find(": ", begin.size()) < first.size() - 2, first);  // a line of ffmpeg follows the code
        CHECK(first.find('\n') == std::string::npos);
        CHECK(error_of([&] { writer.write(grey(63, 36)); }) == first);
        CHECK(error_of([&] { writer.finish(); }) == first);
    }
    CHECK(fs::is_empty(folder.path));
    int status = 0;
    CHECK(waitpid(child, &status, 0) == child);
    CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("an encoder whose exit code the system does not tell is an error") {
    const TemporaryFolder folder;
    const auto handler = std::signal(SIGCHLD, SIG_IGN);
    {
        VideoWriter writer(folder.path / "v.mp4", small_video());
        writer.write(grey(64, 36));
        CHECK_THROWS_AS(writer.finish(), RenderError);
    }
    std::signal(SIGCHLD, handler);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("an APNG does not go to standard output") {
    VideoSettings settings = small_video();
    settings.format = VideoFormat::apng;
    CHECK_THROWS_AS(VideoWriter("/dev/stdout", settings), FileError);
}
