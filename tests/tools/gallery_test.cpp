// `tumble gallery`: its page, sheet, JSON and exit codes.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"
#include "tools/gallery/gallery.hpp"
#include "tools/run/video_output.hpp"
#include "video_probe.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::tools::affordable_threads;
using tumble::tools::GalleryOptions;
using tumble::tools::gifs_at_a_time;

namespace {

// A resting ball; the claim holds if it stays above 0.
std::string scene_of(const std::string& name, const std::string& claim) {
    return R"({"format": 1, "name": ")" + name + R"(", "world": {"duration": 0.5, "gravity": [0, 0]},
      "bodies": [{"name": "ball", "position": [0, 1], "shapes": [{"circle": {"radius": 0.5}}]}],
      "expect": [{"that": ")" +
           claim + R"("}]})";
}

int side(const std::string& png, std::size_t at) {
    return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
}

}  // namespace

TEST_CASE("a gallery has a picture, the claims and the timing of each scene, and a sheet of all") {
    const Folder folder;
    std::vector<std::string> command{"gallery"};
    for (const char* name : {"one", "two", "three"})
        command.push_back(folder.write(std::string(name) + ".json", scene_of(name, "ball.y > 0")));
    const std::filesystem::path out = folder / "gallery";
    for (const char* more : {"--columns", "2", "--size", "160x90", "--jobs", "2", "--json", "-o"})
        command.push_back(more);
    command.push_back(out.string());
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json result = json::parse(answer.out);
    REQUIRE(result["scenes"].size() == 3);
    for (const json& scene : result["scenes"]) {
        CHECK(scene["passed"] == true);
        CHECK(scene["claims"] == 1);
        CHECK(scene["steps"] == 30);
        CHECK(scene["drawn"] == true);
    }
    CHECK(result["scenes"][2]["name"] == "three");
    const std::string sheet = read_text(out / "sheet.png");
    CHECK(side(sheet, 16) == 2 * 160 + 4);  // two columns, two rows, gaps of 4 pixels
    CHECK(side(sheet, 20) == 2 * 90 + 4);
    const std::string page = read_text(out / "index.html");
    CHECK(page.find("three, 0.25 s: 1 of 1 claim holds") != std::string::npos);
    CHECK(page.find("http") == std::string::npos);
    const Answer again = run_tumble(command);
    CHECK(again.code == 4);
}

TEST_CASE("--loop writes a GIF of each scene, which the page shows") {
    const Folder folder;
    const std::string one = folder.write("one.json", scene_of("one", "ball.y > 0"));
    const std::string two = folder.write("two.json", scene_of("one", "ball.y > 0"));  // the same name
    const std::string out = (folder / "gallery").string();
    const std::vector<std::string> command{"gallery", one,      two,   "-o",   out, "--size",
                                           "160x90",  "--loop", "0.5", "--at", "0"};
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const std::string page = read_text(folder / "gallery/index.html");
    for (const std::string name : {"1-one.gif", "2-one.gif"}) {
        const json stream = tumble::test::probe(folder / "gallery/loops" / name)["streams"].at(0);
        CHECK(stream["nb_read_frames"] == "11");  // 0 to 0.5 s at 20 a second
        CHECK(stream["width"] == 160);
        CHECK(page.find("src=\"loops/" + name + "\"") != std::string::npos);
    }
    CHECK(page.find("data:image/png") == std::string::npos);
    CHECK(run_tumble(command).code == 4);
    CHECK(run_tumble({"gallery", one, "-o", out, "--loop", "0.01"}).code == 2);
    const std::string none = (folder / "none").string();
    const std::vector<std::string> sizes{"-o", none, "--size", "1920x1080", "--loop", "60"};
    std::vector<std::string> alone{"gallery", one};
    alone.insert(alone.end(), sizes.begin(), sizes.end());
    const Answer large = run_tumble(alone);
    CHECK(large.code == 2);
    CHECK(large.err.find("--loop: a GIF of this length and size needs 10 GB of memory") != std::string::npos);
    CHECK(large.err.find("one.json") == std::string::npos);  // refused before any scene, not by each
    CHECK_FALSE(std::filesystem::exists(none));
}

TEST_CASE("the memory of all loops that are made at a time is limited") {
    const Folder folder;
    const std::string one = folder.write("one.json", scene_of("one", "ball.y > 0"));
    const std::string none = (folder / "none").string();
    // A loop of 20 s has 401 frames of 640 x 360 pixels: 0.37 GB. Eleven of them have 4.06 GB.
    const auto gallery = [&](std::size_t scenes, const std::string& jobs) {
        std::vector<std::string> command{"gallery", "-o", none, "--size", "640x360", "--loop", "20", "--jobs", jobs};
        command.insert(command.end(), scenes, one);
        return run_tumble(command);
    };
    const Answer refused = gallery(12, "11");
    CHECK(refused.code == 2);
    CHECK_MESSAGE(
        refused.err.find("--loop: 11 GIFs of this length and size at a time need 4.1 GB of memory, more than 4 GB") !=
            std::string::npos,
        refused.err);
    CHECK(refused.err.find("lower --jobs") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(none));
    CHECK(gallery(1, "11").code == 0);  // one at a time
}

TEST_CASE("without --jobs, as many loops are made at a time as the memory allows") {
    CHECK(gifs_at_a_time(0.37e9, 256) == 10);
    CHECK(gifs_at_a_time(0.37e9, 4) == 4);
    CHECK(gifs_at_a_time(1e9, 4) == 4);
    CHECK(gifs_at_a_time(1.01e9, 4) == 3);
    CHECK(gifs_at_a_time(10e9, 4) == 1);  // refused by require_memory()
    CHECK(gifs_at_a_time(0.0, 4) == 4);
    // A loop of 20 s has 401 frames of 640 x 360 pixels, of four bytes each.
    GalleryOptions options{.check = {.threads = 64}, .size = {640, 360}};
    CHECK(affordable_threads(options) == 64);
    options.loop = 20.0;
    CHECK(affordable_threads(options) == 10);
    options.check.threads = 3;
    CHECK(affordable_threads(options) == 3);
}

TEST_CASE("a gallery shows what fails, and text of scenes is no markup") {
    const Folder folder;
    const std::string wrong = folder.write("wrong.json", "{}");
    const std::string failing = folder.write("failing.json", scene_of("</script><img src=x>", "ball.y > 5"));
    const std::string out = (folder / "gallery").string();
    const Answer answer = run_tumble({"gallery", wrong, failing, "-o", out, "--size", "160x90"});
    CHECK(answer.code == 3);
    const std::size_t named = answer.err.find("wrong.json");  // once in a message
    CHECK(answer.err.find("wrong.json", named + 1) == std::string::npos);
    const std::string page = read_text(folder / "gallery/index.html");
    CHECK(page.find("<img src=x>") == std::string::npos);
    CHECK(page.find("&lt;/script&gt;") != std::string::npos);
    CHECK(page.find("failed: expected that") != std::string::npos);
    CHECK(page.find("wrong.json") != std::string::npos);
    CHECK(run_tumble({"gallery", failing, "-o", out, "--size", "160x90", "--force"}).code == 7);
}
