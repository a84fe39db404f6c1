// `init` makes a project whose checks pass, and `watch` checks and draws a scene on each save.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

std::string scene_of(double height) {
    return R"({"format": 1, "world": {"duration": 0.1, "gravity": [0, 0]}, "bodies": [{"name": "ball", "position": [0, )" +
           std::to_string(height) + R"(], "shapes": [{"circle": {"radius": 1}}]}],
           "expect": [{"body": "ball", "height": [1, 3]}]})";
}

// Includes part.json. The settings of the world are its own.
std::string level_scene(const std::string& keys = "") {
    return R"({"format": 1, "world": {"duration": 0.1, "gravity": [0, 0]}, )" + keys +
           R"("include": [{"file": "part.json"}]})";
}

// Waits until the file has this many lines, half a minute at most.
std::vector<json> wait_for_lines(const fs::path& file, std::size_t count, const Process& process) {
    std::vector<json> lines;
    for (int tries = 0; tries < 6000 && lines.size() < count && process.is_running(); ++tries) {
        lines.clear();
        std::ifstream stream(file);
        for (std::string line; std::getline(stream, line) && !stream.eof();) lines.push_back(json::parse(line));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return lines;
}

}  // namespace

TEST_CASE("the checks of a new project pass, and fail after a scene has changed until its hash is updated") {
    const Folder folder;
    const fs::path project = folder / "marble game";
    const Answer made = run_tumble({"init", project.string(), "--json"});
    REQUIRE_MESSAGE(made.code == 0, made.err);
    const json files = json::parse(made.out)["files"];
    CHECK(files.size() == 10);
    for (const json& file : files) CHECK(fs::file_size(project / file.get<std::string>()) > 0);
    CHECK(read_text(project / "scenes/scene.schema.json") == run_tumble({"schema"}).out);
    CHECK(read_text(project / "README.md").starts_with("# marble game\n"));

    for (const char* const workflow : {".github/workflows/physics.yml", ".gitlab-ci.yml", "azure-pipelines.yml"})
        CHECK(read_text(project / workflow).find("debian:12") != std::string::npos);  // for which the package is

    const std::string binary = "TUMBLE=" TUMBLE_BINARY;
    const Answer checked = run({"make", "check", binary}, project);
    CHECK_MESSAGE(checked.code == 0, checked.out << checked.err);
    CHECK(fs::exists(project / "out/report.xml"));
    CHECK(run({"make", "schema", "frames", binary}, project).code == 0);
    CHECK(fs::exists(project / "out/tower.png"));

    // A scene with an error is in the report, which all services publish.
    std::ofstream(project / "scenes/broken.json") << R"({"format": 1, )";
    CHECK(run({"make", "check", binary}, project).code != 0);
    CHECK(read_text(project / "out/report.xml").find("scenes/broken.json") != std::string::npos);
    fs::remove(project / "scenes/broken.json");
    for (const char* const workflow : {".github/workflows/physics.yml", ".gitlab-ci.yml", "azure-pipelines.yml"})
        CHECK(read_text(project / workflow).find("${TUMBLE_PACKAGE:?is not set}") != std::string::npos);
    CHECK(read_text(project / "azure-pipelines.yml").find("publish: out") != std::string::npos);  // the pictures
    CHECK(read_text(project / "Jenkinsfile").find("allowEmptyResults: true") != std::string::npos);

    const std::string tower = read_text(project / "scenes/tower.json");
    const std::size_t at = tower.find("\"velocity\": [6, 0]");
    REQUIRE(at != std::string::npos);
    std::ofstream(project / "scenes/tower.json")
        << tower.substr(0, at) << "\"velocity\": [7, 0]" << tower.substr(at + 18);
    CHECK(run({"make", "check", binary}, project).code != 0);
    CHECK(run({"make", "update", "check", binary}, project).code == 0);
}

TEST_CASE("init replaces no file") {
    const Folder folder;
    folder.write("Makefile", "mine\n");
    const Answer answer = run_tumble({"init", folder.path().string()});
    CHECK(answer.code == 4);
    CHECK(answer.err.find("Makefile") != std::string::npos);
    CHECK(answer.err.find("--force") == std::string::npos);  // which init has not
    CHECK(read_text(folder / "Makefile") == "mine\n");
    CHECK(!fs::exists(folder / "scenes"));
}

TEST_CASE("init names a folder that is to be entered as a shell reads it, and refuses an empty name") {
    const Folder folder;
    const std::string spaced = (folder / "my game").string(), plain = (folder / "game").string();
    CHECK(run_tumble({"init", spaced}).err == "next: cd '" + spaced + "' && make check\n");
    CHECK(run_tumble({"init", plain}).err == "next: cd " + plain + " && make check\n");
    const Answer empty = run_tumble({"init", ""});
    CHECK(empty.code == 2);
    CHECK(empty.err.find("needs the name of a folder, got an empty one") != std::string::npos);
}

TEST_CASE("watch checks and draws a scene, and again after each save of it or of a part, until it is interrupted") {
    const Folder folder;
    const std::string part = folder.write("part.json", scene_of(2.0));
    const std::string scene = folder.write("level.json", level_scene());
    const fs::path picture = folder / "level.png", log = folder / "log.txt";
    Process process(tumble_command({"watch", scene, "-o", picture.string(), "--size", "64x36", "--json"}), ".", "",
                    log.string());
    std::vector<json> lines = wait_for_lines(log, 1, process);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0]["passed"] == true);
    CHECK(lines[0]["picture"] == picture.string());
    const std::string first = read_text(picture);
    CHECK(first.starts_with("\x89PNG"));

    folder.write("part.json", scene_of(4.0));  // written in place
    lines = wait_for_lines(log, 2, process);
    REQUIRE(lines.size() == 2);
    CHECK(lines[1]["passed"] == false);

    folder.write("level.json~", level_scene(R"("camera": {"center": [0, 9], "height": 30}, )"));
    fs::rename(folder / "level.json~", scene);  // as editors do
    lines = wait_for_lines(log, 3, process);
    REQUIRE(lines.size() == 3);
    CHECK(read_text(picture) != first);

    folder.write("level.json", R"({"format": 1, )");
    lines = wait_for_lines(log, 4, process);
    REQUIRE(lines.size() == 4);
    CHECK(lines[3]["passed"] == false);
    CHECK(lines[3]["error"].get<std::string>().find("level.json:1") != std::string::npos);
    CHECK(lines[3]["picture"] == "");

    folder.write("other.json", "{}");  // not a part of the scene
    folder.write("level.json", level_scene());
    lines = wait_for_lines(log, 5, process);
    CHECK(lines.size() == 5);
    process.send_signal(SIGINT);
    CHECK(process.wait().code == 130);
}

TEST_CASE("watch refuses standard input, a missing file, and a picture that is not a PNG file") {
    const Folder folder;
    const std::string scene = folder.write("level.json", scene_of(2.0));
    CHECK(run_tumble({"watch", "-"}).code == 2);
    CHECK(run_tumble({"watch", (folder / "none.json").string()}).code == 4);
    CHECK(run_tumble({"watch", scene, "-o", (folder / "level.gif").string()}).code == 2);
}
