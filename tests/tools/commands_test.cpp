// The output of the other subcommands.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

#include "process.hpp"
#include "support/near.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::kDouble;
using tumble::test::near;
using tumble::test::run_tumble;

TEST_CASE("without arguments seven lines show the usage and a command to copy") {
    const Answer answer = run_tumble({});
    CHECK(answer.code == 0);
    CHECK(std::count(answer.out.begin(), answer.out.end(), '\n') == 8);
    CHECK(answer.out.find("\nTry: ") != std::string::npos);
    CHECK(answer.err.empty());
}

TEST_CASE("TUMBLE_SIMD chooses the instruction set, and a set that is not there ends with exit code 2") {
    const json version = json::parse(run_tumble({"--version", "--json"}).out);
    const auto run_with = [](const std::string& set) {
        std::vector<std::string> command = tumble::test::tumble_command({"--version", "--json"});
        command.insert(command.begin(), {"env", "TUMBLE_SIMD=" + set});
        return tumble::test::run(command);
    };
    REQUIRE(version["instruction_sets"].size() >= 1);
    for (const std::string set : version["instruction_sets"]) {
        CAPTURE(set);
        const Answer answer = run_with(set);
        CHECK(answer.code == 0);
        CHECK(json::parse(answer.out)["simd"] == set);
    }
    CHECK(json::parse(run_with("").out)["simd"] == version["simd"]);
    const Answer unknown = run_with("sse9");
    CHECK(unknown.code == 2);
    CHECK(unknown.out.empty());
    CHECK(unknown.err.find("TUMBLE_SIMD is 'sse9'; this build knows baseline") != std::string::npos);
}

TEST_CASE("--version prints version, compiler and instruction sets") {
    const Answer answer = run_tumble({"--version"});
    CHECK(answer.code == 0);
    CHECK(answer.out.starts_with("tumble 0."));
    const json version = json::parse(run_tumble({"--version", "--json"}).out);
    for (const char* key : {"version", "compiler", "build_type", "simd", "instruction_sets", "processor_has"})
        CHECK(version.contains(key));
}

TEST_CASE("every subcommand has help on standard output") {
    for (const char* command : {"run", "demo", "shot", "validate", "schema", "distance", "import", "bench", "check",
                                "diff", "fmt", "parity", "plot", "compare", "gallery", "shrink"}) {
        CAPTURE(command);
        const Answer answer = run_tumble({command, "--help"});
        CHECK(answer.code == 0);
        CHECK(answer.err.empty());
        CHECK(answer.out.find("--json") != std::string::npos);
    }
}

TEST_CASE("validate reports the result of each scene") {
    const Folder folder;
    const std::string good = folder.write("good.json", tumble::test::small_scene());
    const std::string bad = folder.write("bad.json", "{}");
    const Answer valid = run_tumble({"validate", good});
    CHECK(valid.code == 0);
    CHECK(valid.out == good + ": valid, 3 bodies, 0 joints\n");
    const Answer both = run_tumble({"validate", bad, good, "--json"});
    CHECK(both.code == 3);
    const json scenes = json::parse(both.out)["scenes"];
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0]["valid"] == false);
    CHECK(scenes[0]["diagnostics"].size() >= 1);
    CHECK(scenes[1]["valid"] == true);
    CHECK(run_tumble({"validate", bad, (folder / "missing.json").string()}).code == 4);
}

TEST_CASE("validate counts warnings, and with --strict they end with exit code 3") {
    const Folder folder;
    const std::string tiny = folder.write(
        "tiny.json", R"({"format": 1, "bodies": [{"name": "dot", "shapes": [{"circle": {"radius": 0.001}}]}]})");
    const Answer warned = run_tumble({"validate", tiny});
    CHECK(warned.code == 0);
    CHECK(warned.out == tiny + ": valid, 1 body, 0 joints, 1 warning\n");
    CHECK(run_tumble({"validate", tiny, "--strict"}).code == 3);
    const Answer larger = run_tumble({"validate", tiny, "--strict", "--set", "/bodies/dot/shapes/0/circle/radius=0.5"});
    CHECK(larger.code == 0);
    CHECK(larger.out == tiny + ": valid, 1 body, 0 joints\n");
}

TEST_CASE("`tumble help` equals `tumble --help`, also for one command") {
    CHECK(run_tumble({"help"}).out == run_tumble({"--help"}).out);
    CHECK(run_tumble({"help", "run"}).out == run_tumble({"run", "--help"}).out);
}

TEST_CASE("every shipped scene is valid and has a description") {
    const json demos = json::parse(run_tumble({"demo", "--list", "--json"}).out);
    CHECK(demos.size() >= 11);
    for (const json& demo : demos) {
        CAPTURE(demo["name"]);
        CHECK_FALSE(demo["description"].get<std::string>().empty());
        CHECK(run_tumble({"validate", demo["file"].get<std::string>()}).code == 0);
    }
}

TEST_CASE("demo --print prints a scene as one file, and demo -o does not replace a folder of the user") {
    const Folder folder;
    CHECK(run_tumble({"demo", "see_saw", "--print"}).out ==
          tumble::test::read_text(TUMBLE_SOURCE_DIR "/scenes/see_saw.json"));
    const std::string convoy = folder.write("convoy.json", run_tumble({"demo", "convoy", "--print"}).out);
    CHECK(run_tumble({"validate", convoy}).code == 0);
    CHECK(json::parse(run_tumble({"demo", "see_saw", "--print", "--json"}).out)["name"] == "see_saw");
    CHECK(run_tumble({"demo", "no_such_scene", "--print"}).code == 2);
    CHECK(run_tumble({"demo", "pendulum", "-o", folder.path().string()}).code == 4);  // not empty
}

TEST_CASE("schema prints the published schema") {
    const Answer answer = run_tumble({"schema"});
    CHECK(answer.code == 0);
    CHECK(json::parse(answer.out).contains("$schema"));
    CHECK(json::parse(answer.out) ==
          json::parse(tumble::test::read_text(TUMBLE_SOURCE_DIR "/scenes/scene.schema.json")));
}

TEST_CASE("import writes a valid scene and refuses to replace one") {
    const Folder folder;
    const std::string source = folder.write("export.json", R"({
        "gravity": {"x": 0, "y": -10}, "allowSleep": true,
        "body": [{"name": "ball", "type": 2, "position": {"x": 0, "y": 2}, "angle": 0, "linearVelocity": 0,
                  "angularVelocity": 0, "bullet": true,
                  "fixture": [{"name": "f", "density": 1, "friction": 0.2,
                               "circle": {"center": 0, "radius": 0.5}}]}]})");
    const std::string scene = (folder / "scene.json").string();
    const Answer answer = run_tumble({"import", source, "-o", scene, "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(json::parse(answer.out)["bodies"] == 1);
    CHECK(run_tumble({"validate", scene}).code == 0);
    CHECK(run_tumble({"import", source, "-o", scene}).code == 4);
    CHECK(run_tumble({"import", source, "-o", source, "--force"}).code == 2);  // it would replace the export
    CHECK(run_tumble({"import", folder.write("no.json", "{"), "-o", (folder / "b.json").string()}).code == 3);
    CHECK_FALSE(fs::exists(folder / "b.json"));
}
