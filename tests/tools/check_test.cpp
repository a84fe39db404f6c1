// `check`, `fmt` and `import`, as scripts use them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

// A crate that rests on the floor from the start. Its claim expects it no lower than `lowest_y`.
std::string crate_scene(const std::string& lowest_y) {
    return R"({"format": 1, "name": "crate & floor", "world": {"duration": 1}, "bodies": [
        {"name": "floor", "type": "static", "shapes": [{"box": {"size": [9, 1]}}]},
        {"name": "crate", "position": [0, 1], "shapes": [{"box": {"size": [1, 1]}}]}],
        "expect": [{"at_rest_by": 0.5}, {"body": "crate", "inside": [[-1, )" +
           lowest_y + R"(], [1, 5]]}]})";
}

// A report without the times of its scenes, " (0.01 s)".
std::string without_times(const std::string& report) {
    return std::regex_replace(report, std::regex(R"( \([0-9]+\.[0-9]{2} s\)\n)"), "\n");
}

}  // namespace

TEST_CASE("check reports the scenes that it is given, in their order") {
    const std::string scenes = TUMBLE_SOURCE_DIR "/scenes/";
    const Answer answer =
        run_tumble({"check", "--json", scenes + "pendulum.json", scenes + "see_saw.json", scenes + "bridge.json"});
    CHECK_MESSAGE(answer.code == 0, answer.out);
    const json found = json::parse(answer.out)["scenes"];
    REQUIRE(found.size() == 3);
    CHECK(found[1]["file"] == scenes + "see_saw.json");
    for (const json& scene : found) CHECK(scene["passed"] == true);
}

TEST_CASE("a failed claim ends with exit code 7, and the report shows what was expected and found") {
    const Folder folder;
    const std::string good = folder.write("good.json", crate_scene("0.9")),
                      bad = folder.write("bad.json", crate_scene("2"));
    CHECK(run_tumble({"check", good}).code == 0);
    const Answer one = run_tumble({"check", good});
    CHECK(without_times(one.out) == good + ": 2 of 2 claims hold\n");
    CHECK(one.out != without_times(one.out));

    const Answer answer = run_tumble({"check", good, bad});
    CHECK(answer.code == 7);
    CHECK(without_times(answer.out) ==
          good + ": 2 of 2 claims hold\n" + bad + ": 1 of 2 claims hold\n  " + bad +
              ": /expect/1 failed: expected that 'crate' is inside [-1, 2] to [1, 5] at the end\n"
              "    at 1 s (step 60): it is at [0, 1]\n");
    CHECK(answer.err.empty());
    CHECK(run_tumble({"check", bad, "--set", "/expect/1/inside/0/1=0.9"}).code == 0);

    const json document = json::parse(run_tumble({"check", bad, good, "--json", "--jobs", "2"}).out);
    CHECK(document["passed"] == false);
    CHECK(document["scenes"][0]["expectations"][1]["pointer"] == "/expect/1");
    CHECK(document["scenes"][0]["expectations"][1]["passed"] == false);
    CHECK(document["scenes"][0]["expectations"][1]["time"] == 1.0);
    CHECK(document["scenes"][1]["passed"] == true);
}

TEST_CASE("the exit code reports an unreadable scene before a failed claim") {
    const Folder folder;
    const std::string bad = folder.write("bad.json", crate_scene("2")), broken = folder.write("broken.json", "{");
    const Answer both = run_tumble({"check", broken, bad});
    CHECK(both.code == 3);
    const std::size_t unread = both.out.find(broken + ":1:2: "), failed = both.out.find(bad + ": /expect/1 failed");
    CHECK(unread < failed);
    CHECK(failed != std::string::npos);
    CHECK(run_tumble({"check", bad, (folder / "missing.json").string()}).code == 4);
}

TEST_CASE("check writes JUnit and draws the deciding step of a failure") {
    const Folder folder;
    const std::string bad = folder.write("bad.json", crate_scene("2")), junit = (folder / "results/junit.xml").string();
    CHECK(run_tumble({"check", bad, "--junit", junit, "--shots", (folder / "shots").string()}).code == 7);
    const std::string text = read_text(junit);
    CHECK(text.find("tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\"") != std::string::npos);
    CHECK(text.find("name=\"/expect/1: 'crate' is inside") != std::string::npos);
    CHECK(text.find("<failure message=\"at 1 s (step 60): it is at [0, 1]\"/><system-out>picture: ") !=
          std::string::npos);
    CHECK(fs::file_size(folder / "shots/crate___floor-expect-1.png") > 1000);
    CHECK(run_tumble({"check", bad, "--junit", junit}).code == 4);
    CHECK(run_tumble({"check", bad, "--junit", junit, "--force"}).code == 7);
}

TEST_CASE("pictures of scenes with equal names get numbers, and existing pictures do not change the exit code") {
    const Folder folder;
    fs::create_directory(folder / "b");
    const std::string one = folder.write("x.json", crate_scene("2")),
                      other = folder.write("b/x.json", crate_scene("3"));
    const std::vector<std::string> arguments{"check", one, other, "--shots", (folder / "shots").string(), "--json"};
    const Answer first = run_tumble(arguments);
    CHECK(first.code == 7);
    const json document = json::parse(first.out);
    CHECK(document["scenes"][0]["expectations"][1]["shot"] == (folder / "shots/crate___floor-expect-1.png").string());
    CHECK(document["scenes"][1]["expectations"][1]["shot"] == (folder / "shots/crate___floor-2-expect-1.png").string());
    CHECK(fs::exists(folder / "shots/crate___floor-2-expect-1.png"));
    const Answer again = run_tumble(arguments);
    CHECK(again.code == 7);
    CHECK(again.err.find("no picture of a failed claim: ") != std::string::npos);
}

TEST_CASE("the picture of a failure shows the name of the scene, or of its file") {
    const Folder folder;
    std::string text = crate_scene("2");
    const std::string file = folder.write("crate & floor.json", text), shots = (folder / "shots").string();
    REQUIRE(run_tumble({"check", file, "--shots", shots}).code == 7);
    const std::string named = read_text(folder / "shots/crate___floor-expect-1.png");
    const std::string name = R"("name": "crate & floor", )";
    folder.write("crate & floor.json", text.erase(text.find(name), name.size()));
    REQUIRE(run_tumble({"check", file, "--shots", shots, "--force"}).code == 7);
    CHECK(read_text(folder / "shots/crate___floor-expect-1.png") == named);
    CHECK(run_tumble({"check", file, "--shots", shots, "--force", "--set", "/name=other"}).code == 7);
    CHECK(read_text(folder / "shots/other-expect-1.png") != named);
}

TEST_CASE("fmt prints the canonical form and warns of lost comments") {
    const Folder folder;
    const std::string file = folder.write("a.json",
                                          "// mine: \"\n{\"bodies\": [], /* // */ \"name\": \"//\\\"/*\", \"world\": "
                                          "{\"substeps\": 4}, \"format\": 1} // end");
    const Answer answer = run_tumble({"fmt", file});
    CHECK(answer.code == 0);
    CHECK(answer.out == "{\n  \"format\": 1,\n  \"name\": \"//\\\"/*\"\n}\n");
    CHECK(answer.err.find("3 comments are dropped") != std::string::npos);
    CHECK(read_text(file).starts_with("// mine"));
    CHECK(json::parse(run_tumble({"fmt", file, "--json"}).out)["comments_lost"] == 3);
    const Answer refused = run_tumble({"fmt", file, "--write"});
    CHECK(refused.code == 4);
    CHECK(refused.err.find("a.json: has 3 comments") != std::string::npos);
    CHECK(read_text(file).starts_with("// mine"));
    CHECK(run_tumble({"fmt", file, "--write", "--force"}).code == 0);
    CHECK(read_text(file) == answer.out);
    CHECK(json::parse(run_tumble({"fmt", file, "--json"}).out)["canonical"] == true);
}

TEST_CASE("a schema among the scenes is skipped") {
    const Folder folder;
    const std::string scene = folder.write("a.json", R"({"format": 1})"),
                      schema = folder.write("scene.schema.json", "{}");
    for (const char* command : {"check", "validate"}) {
        const Answer both = run_tumble({command, scene, schema});
        CHECK(both.code == 0);
        CHECK(both.err.find("skipped") != std::string::npos);
        CHECK(run_tumble({command, schema}).code == 3);
    }
}

TEST_CASE("fmt keeps includes, and fmt --flat resolves them") {
    const Folder folder;
    fs::create_directory(folder / "parts");
    folder.write("parts/ball.json",
                 R"({"format": 1, "bodies": [{"name": "ball", "shapes": [{"circle": {"radius": 1}}]}]})");
    const std::string file =
        folder.write("a.json", R"({"format": 1, "include": [{"file": "parts/ball.json", "prefix": "a/"}]})");
    const json kept = json::parse(run_tumble({"fmt", file}).out),
               flat = json::parse(run_tumble({"fmt", file, "--flat"}).out);
    CHECK(kept["include"].size() == 1);
    CHECK(!kept.contains("bodies"));
    CHECK(!flat.contains("include"));
    CHECK(flat["bodies"][0]["name"] == "a/ball");
    fs::remove(folder / "parts/ball.json");
    const Answer missing = run_tumble({"validate", file});
    CHECK(missing.code == 3);
    CHECK(missing.err.find("a.json:1:36: /include/0/file: ") != std::string::npos);
}

TEST_CASE("import reads SVG drawings by their extension") {
    const Folder folder;
    const std::string drawing = folder.write(
        "page.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100"><rect width="20" height="10"/></svg>)");
    const std::string scene = (folder / "page.json").string();
    CHECK(run_tumble({"import", drawing, "-o", scene, "--scale", "0.1"}).code == 0);
    const json written = json::parse(read_text(scene));
    REQUIRE(written["bodies"].size() == 1);
    CHECK(written["bodies"][0]["shapes"][0]["box"]["size"] == json::array({2, 1}));
    const Answer marked = run_tumble(
        {"import", folder.write("floor.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">
        <rect width="20" height="10"/><rect class="static" y="90" width="100" height="10"/></svg>)"),
         "-o", (folder / "floor.json").string()});
    CHECK(marked.out.find("2 bodies (1 dynamic, 1 static), 0 joints") != std::string::npos);
    CHECK(marked.err.find("class=\"static\"") != std::string::npos);
    CHECK(run_tumble({"import", "--help"}).out.find("class=\"static\"") != std::string::npos);
    CHECK(run_tumble({"import", drawing, "-o", (folder / "b.json").string(), "--scale", "nan"}).code == 2);
}
