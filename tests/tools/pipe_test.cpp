// Standard input and output in place of files.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "process.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

// Runs tumble with this text as standard input.
Answer feed(const std::string& input, const std::vector<std::string>& arguments, const fs::path& folder = ".") {
    return Process(tumble_command(arguments), folder, input).wait();
}

// A scene of a box that a second file contains.
constexpr const char* kIncluding =
    R"({"format": 1, "include": [{"file": "part.json"}], "expect": [{"body": "box", "height": [-200, 0]}]})";
constexpr const char* kPart = R"({"format": 1, "bodies": [{"name": "box", "shapes": [{"box": {"size": [1, 1]}}]}]})";

}  // namespace

TEST_CASE("a scene from standard input includes files of the current folder") {
    const Folder folder;
    folder.write("part.json", kPart);
    const Answer checked = feed(kIncluding, {"check", "-"}, folder.path());
    CHECK_MESSAGE(checked.code == 0, checked.err);
    CHECK(checked.out.find("-: 1 of 1 claim holds") != std::string::npos);
    CHECK(feed(kIncluding, {"check", "/dev/stdin"}, folder.path()).code == 0);
    CHECK(feed(kIncluding, {"validate", "-"}, folder.path()).out == "-: valid, 1 body, 0 joints\n");
    CHECK(feed(kIncluding, {"fmt", "-", "--flat"}, folder.path()).out.find("\"box\"") != std::string::npos);
    CHECK(feed(kIncluding, {"fmt", "-", "--write"}, folder.path()).code == 2);
    const Answer run = feed(kIncluding, {"run", "-", "--no-frames"}, folder.path());
    CHECK(run.out.starts_with("stdin: 300 steps"));
    CHECK(fs::exists(folder / "out/stdin/summary.json"));

    const Answer wrong = feed("{\n}", {"validate", "-"});
    CHECK(wrong.code == 3);
    CHECK(wrong.err.starts_with("<stdin>:1:1: "));
    CHECK(feed("", {"run", "-"}).code == 3);
}

TEST_CASE("a table on standard output has the bytes of its file, and the report goes to standard error") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string out = (folder / "out").string(), file = (folder / "t.csv").string();
    const std::vector<std::string> run{"run", scene, "--no-frames", "--force", "--duration", "3", "-o", out};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = run;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tumble(arguments);
    };
    REQUIRE(with({"--trajectory", file}).code == 0);
    const Answer piped = with({"--trajectory", "-"});
    CHECK(piped.code == 0);
    CHECK(piped.out == read_text(file));
    CHECK(piped.err.find("180 steps") != std::string::npos);
    CHECK(with({"--trajectory", "/dev/stdout"}).out == read_text(file));  // a redirected file needs no --force
    const Answer twice = with({"--trajectory", "-", "--hashes", "/dev/stdout"});
    CHECK(twice.code == 2);
    CHECK(twice.err.find("error: --hashes: names standard output, which another option names too") !=
          std::string::npos);
    CHECK(with({"--trajectory", "-", "--json"}).code == 2);
    const json summary = json::parse(read_text(folder / "out/summary.json"));
    CHECK(summary["files"][1]["bytes"] == fs::file_size(file));

    CHECK(feed(read_text(file), {"diff", "-", file}).code == 0);
    CHECK(feed(read_text(file), {"diff", scene, "-", "--tolerance", "0"}).code == 7);  // it ends earlier
}

TEST_CASE("a plan from standard input makes the sweep of its file") {
    const Folder folder;
    folder.write("scene.json", tumble::test::small_scene());
    const std::string plan = R"({"format": 1, "scene": "scene.json", "seeds": {"count": 3}})";
    folder.write("plan.json", plan);
    const Answer from_file = feed("", {"sweep", "plan.json", "-o", "a"}, folder.path());
    REQUIRE_MESSAGE(from_file.code == 0, from_file.err);
    const Answer piped = feed(plan, {"sweep", "-", "-o", "b"}, folder.path());
    REQUIRE_MESSAGE(piped.code == 0, piped.err);
    CHECK(read_text(folder / "a/manifest.jsonl") == read_text(folder / "b/manifest.jsonl"));
    CHECK(read_text(folder / "a/runs.csv") == read_text(folder / "b/runs.csv"));
    CHECK(feed(plan, {"sweep", "verify", "b", "-", "--part", "1"}, folder.path()).code == 0);
    const Answer wrong = feed("{\n}", {"sweep", "-", "-o", "c"}, folder.path());
    CHECK(wrong.code == 3);
    CHECK(wrong.err.starts_with("<stdin>:1:1: "));
    CHECK(feed(plan, {"sweep", "submit", "-", "-o", "d", "--slurm", "--print"}, folder.path()).code == 2);
}

TEST_CASE("an option that names a folder refuses standard output, and every output an empty name") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    for (const std::string name : {"-", "/dev/stdout", ""})
        for (const auto& command :
             std::vector<std::vector<std::string>>{{"run", scene, "-o"},
                                                   {"demo", "pendulum", "-o"},
                                                   {"gallery", scene, "-o"},
                                                   {"check", scene, "--shots"},
                                                   {"compare", scene, scene, "--frames"},
                                                   {"init"},
                                                   {"sweep", "p.json", "-o"},
                                                   {"sweep", "submit", "p.json", "-o"},
                                                   {"sweep", "export", "s", "--id", "a-v0", "-o"}}) {
            std::vector<std::string> arguments = command;
            arguments.push_back(name);
            CAPTURE(arguments);
            const Answer answer = feed("", arguments, folder.path());
            CHECK(answer.code == 2);
            CHECK(answer.err.find(name.empty() ? "needs the name of a folder" : "names a folder") != std::string::npos);
        }
    for (const auto& command : std::vector<std::vector<std::string>>{{"check", scene, "--junit"},
                                                                     {"run", scene, "--trajectory"},
                                                                     {"compare", scene, scene, "--video"},
                                                                     {"shot", scene, "-o"},
                                                                     {"shrink", scene, "-o"},
                                                                     {"watch", scene, "-o"}}) {
        std::vector<std::string> arguments = command;
        arguments.emplace_back();  // as from a variable that is not set
        CAPTURE(arguments);
        const Answer unnamed = feed("", arguments, folder.path());
        CHECK(unnamed.code == 2);
        CHECK(unnamed.err.find(command.back() == "-o" ? "--output: needs" : command.back() + ": needs") !=
              std::string::npos);
        CHECK(unnamed.err.find("needs the name of a file, got an empty one") != std::string::npos);
    }
}

TEST_CASE("an option that names a page refuses the names of other formats") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    for (const std::string option : {"--replay", "--report"}) {
        const Answer answer = feed("", {"run", scene, "--no-frames", option, "page.png"}, folder.path());
        CHECK(answer.code == 2);
        CHECK(answer.err.find(option + ": pages are HTML: choose a name that ends in .html, not page.png") !=
              std::string::npos);
    }
    CHECK(feed("", {"run", scene, "--no-frames", "--replay", "page.PNG"}, folder.path()).code == 2);
    CHECK(feed("", {"run", scene, "--no-frames", "--hashes", "hashes.JSON"}, folder.path()).code == 2);
    CHECK(feed("", {"run", scene, "--no-frames", "--duration", "0.1", "--replay", "page"}, folder.path()).code == 0);
}

TEST_CASE("outputs that must be files refuse standard output and say why") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const Answer shrink = run_tumble({"shrink", scene, "-o", "-"}), watch = run_tumble({"watch", scene, "-o", "-"});
    CHECK(shrink.code == 2);
    CHECK(shrink.err.find("from which the search continues") != std::string::npos);
    CHECK(watch.code == 2);
    CHECK(watch.err.find("replaced on each save") != std::string::npos);
}

TEST_CASE("a reader that closes the pipe ends the run and leaves no partial file") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string out = (folder / "out").string();
    const Answer answer =
        tumble::test::run({"/bin/bash", "-c",
                           "set -o pipefail; " TUMBLE_BINARY " run " + scene + " --no-frames --duration 1000 -o " +
                               out + " --trajectory - --hashes " + out + "/h.csv | head -n 1"});
    CHECK(answer.code == 4);
    CHECK(answer.out == "step,time,body,x,y,angle,vx,vy,omega\n");
    CHECK(answer.err.find("Broken pipe") != std::string::npos);
    CHECK(json::parse(read_text(folder / "out/summary.json"))["complete"] == false);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out"))
        CHECK(entry.path().extension() != ".partial");
}

TEST_CASE("pictures, reports and scenes go to standard output") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene());
    const std::string file = (folder / "shot.png").string(), junit = (folder / "j.xml").string();
    REQUIRE(run_tumble({"shot", scene, "-o", file, "--size", "64x64"}).code == 0);
    const Answer shot = run_tumble({"shot", scene, "-o", "-", "--size", "64x64"});
    CHECK(shot.code == 0);
    CHECK(shot.out == read_text(file));
    CHECK(run_tumble({"check", scene, "--junit", "-"}).out.starts_with("<?xml"));
    const std::string drawing =
        R"(<svg xmlns="http://www.w3.org/2000/svg"><rect id="r" width="40" height="20"/></svg>)";
    const Answer imported = feed(drawing, {"import", "-", "-o", "-"});
    CHECK_MESSAGE(imported.code == 0, imported.err);
    CHECK(json::parse(imported.out)["bodies"][0]["name"] == "r");
    CHECK(imported.err.find("1 body (") != std::string::npos);
    CHECK(feed(drawing, {"import", "-", "-o", "-", "--check"}).code == 2);
}

TEST_CASE("a wrong --set is a wrong argument in every command") {
    const Folder folder;
    const std::string scene = folder.write("small.json", tumble::test::small_scene()),
                      out = (folder / "o.png").string();
    for (const std::string change : {"/nowhere/at/all=1", "/world/substeps=-1", "no pointer"}) {
        CAPTURE(change);
        CHECK(run_tumble({"run", scene, "--no-frames", "-o", out, "--set", change}).code == 2);
        CHECK(run_tumble({"shot", scene, "-o", out, "--set", change}).code == 2);
        CHECK(run_tumble({"check", scene, "--set", change}).code == 2);
        CHECK(run_tumble({"validate", scene, "--set", change}).code == 2);
        CHECK(run_tumble({"diff", scene, scene, "--set", change}).code == 2);
    }
    const std::string broken = folder.write("broken.json", R"({"format": 1, "world": {"seed": -1}})");
    CHECK(run_tumble({"check", broken, "--set", "/world/substeps=-1"}).code == 3);  // the file is wrong too
}
