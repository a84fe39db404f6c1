// Themes and plots of frames, by the command line.
#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"
#include "tumble/render.hpp"

using namespace tumble;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;

namespace {

std::string sliding_puck(const std::string& style) {
    return R"({"format": 1, "world": {"gravity": [0, 0], "duration": 1}, "camera": {"center": [1, 0], "height": 9, "style": )" +
           style + R"(}, "bodies": [{"name": "puck", "velocity": [2, 0], "shapes": [{"circle": {"radius": 0.5}}]}]})";
}

std::array<int, 3> color_at(const Image& image, int x, int y) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {image.rgba.at(at), image.rgba.at(at + 1), image.rgba.at(at + 2)};
}

// The first column from the left with a pixel in the colour of the line of the time; -1 for none.
int time_column(const Image& image, int row) {
    for (int x = 0; x < image.width; ++x)
        if (color_at(image, x, row) == std::array<int, 3>{198, 40, 40}) return x;
    return -1;
}

}  // namespace

TEST_CASE("--theme replaces the theme of the scene, in a shot and in frames") {
    const Folder folder;
    const std::string dark = folder.write("dark.json", sliding_puck(R"({"theme": "dark"})"));
    const std::string plain = folder.write("plain.json", sliding_puck("{}"));
    const auto corner = [&](const std::string& scene, const std::vector<std::string>& options) {
        std::vector<std::string> command{
            "shot", scene, "-o", (folder / "shot.png").string(), "--size", "320x180", "--hide", "grid", "--force"};
        command.insert(command.end(), options.begin(), options.end());
        REQUIRE(run_tumble(command).code == 0);
        return color_at(read_png(folder / "shot.png"), 2, 2);
    };
    CHECK(corner(plain, {}) == std::array<int, 3>{247, 248, 250});
    CHECK(corner(dark, {}) == std::array<int, 3>{20, 25, 29});
    CHECK(corner(dark, {"--theme", "light"}) == std::array<int, 3>{247, 248, 250});
    CHECK(corner(plain, {"--theme", "high_contrast"}) == std::array<int, 3>{0, 0, 0});
    CHECK(corner(plain, {"--theme", "print"}) == std::array<int, 3>{255, 255, 255});
    const Answer wrong = run_tumble({"shot", plain, "-o", (folder / "no.png").string(), "--theme", "pink"});
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find("color_blind") != std::string::npos);

    const std::string frames = (folder / "frames").string();
    REQUIRE(run_tumble({"run", plain, "-o", frames, "--fps", "1", "--size", "320x180", "--theme", "dark"}).code == 0);
    CHECK(color_at(read_png(folder / "frames/frames/frame_000000.png"), 2, 177) == std::array<int, 3>{20, 25, 29});
}

TEST_CASE("a replay has the colours of all themes, and opens in that of --theme") {
    const Folder folder;
    const std::string plain = folder.write("plain.json", sliding_puck("{}"));
    const auto page = [&](const std::vector<std::string>& options) {
        std::vector<std::string> command{
            "run", plain, "-o", (folder / "out").string(), "--no-frames", "--replay", "-", "--force", "--quiet"};
        command.insert(command.end(), options.begin(), options.end());
        const Answer answer = run_tumble(command);
        REQUIRE_MESSAGE(answer.code == 0, answer.err);
        return answer.out;
    };
    const std::string plain_page = page({});
    for (const ThemeName& theme : kThemes)
        CHECK(plain_page.find(":root[data-theme=\"" + std::string(theme.name) + "\"] { --ground: #") !=
              std::string::npos);
    // Only the packed states, which name the theme, differ.
    const std::string light = page({"--theme", "light"}), dark = page({"--theme", "dark"});
    CHECK(page({}) == plain_page);
    CHECK(light != plain_page);
    CHECK(dark != light);
}

TEST_CASE("--plot puts plots below the frames, with a line at the time of each frame") {
    const Folder folder;
    const std::string scene = folder.write("puck.json", sliding_puck("{}"));
    const std::string out = (folder / "out").string();
    const Answer answer = run_tumble(
        {"run", scene, "-o", out, "--fps", "2", "--size", "640x360", "--plot", "puck.x", "puck.speed", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    std::vector<int> columns;
    for (const char* const name : {"frame_000000.png", "frame_000001.png", "frame_000002.png"}) {
        const Image frame = read_png(folder / "out/frames" / name);
        CHECK(frame.width == 640);
        CHECK(frame.height == 360 + 2 * 180);
        columns.push_back(time_column(frame, 360 + 80));
        CHECK(time_column(frame, 360 + 180 + 80) == columns.back());  // the axes are one below the other
        CHECK(time_column(frame, 180) == -1);
    }
    // 0, 0.5 and 1 s of an axis from 0 to 1 s.
    CHECK(columns[0] > 0);
    CHECK(columns[2] > 600);
    CHECK(std::abs(columns[0] + columns[2] - 2 * columns[1]) <= 1);
}

TEST_CASE("--plot refuses wrong expressions and narrow frames before anything is written") {
    const Folder folder;
    const std::string scene = folder.write("puck.json", sliding_puck("{}"));
    const std::string out = (folder / "out").string();
    const Answer wrong = run_tumble({"run", scene, "-o", out, "--plot", "pck.x"});
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find("did you mean 'puck'") != std::string::npos);
    const Answer narrow = run_tumble({"run", scene, "-o", out, "--plot", "puck.x", "--size", "200x200"});
    CHECK(narrow.code == 2);
    CHECK(narrow.err.find("at least 320 pixels in width") != std::string::npos);
    CHECK(!std::filesystem::exists(out));
    const Answer unused = run_tumble({"run", scene, "-o", out, "--no-frames", "--plot", "puck.x"});
    CHECK(unused.code == 0);
    CHECK(unused.err.find("--plot has no effect with --no-frames") != std::string::npos);
}
