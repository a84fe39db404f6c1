// Errors of users: the exit code and the message for each.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "process.hpp"

using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;

namespace {

std::string body_scene(const std::string& shape) {
    return R"({"format": 1, "name": "bad", "bodies": [{"name": "a", "shapes": [)" + shape + "]}]}";
}

// Runs a scene with this text, without frames.
Answer run_text(const std::string& text) {
    const Folder folder;
    const std::string scene = folder.write("scene.json", text);
    return run_tumble({"run", scene, "--no-frames", "-o", (folder / "out").string()});
}

void check_invalid(const std::string& text, const std::string& expected_message) {
    CAPTURE(text);
    const Answer answer = run_text(text);
    CHECK(answer.code == 3);
    CHECK(answer.out.empty());
    CHECK_MESSAGE(answer.err.find("scene.json:") != std::string::npos, answer.err);
    CHECK_MESSAGE(answer.err.find(expected_message) != std::string::npos, answer.err);
}

}  // namespace

TEST_CASE("an invalid scene ends with exit code 3, and the message names the location") {
    check_invalid("", "the file is empty");
    check_invalid(R"({"format": 1, "bodies": [)", "scene.json:1:");
    check_invalid(R"({"format": 1, "bodys": []})", "bodies");
    check_invalid(R"({"format": 1, "name": "a", "name": "b", "bodies": []})", "name");
    check_invalid(R"({"format": 1, "bodies": [{"position": [NaN, 0], "shapes": [{"circle": {"radius": 1}}]}]})", ":1:");
    check_invalid(R"({"format": 1, "bodies": [{"position": [1e999, 0], "shapes": [{"circle": {"radius": 1}}]}]})",
                  ":1:");
    check_invalid(body_scene(R"({"polygon": {"vertices": [[0, 0], [1, 0]]}})"), "/bodies/0/shapes/0/polygon");
    check_invalid(body_scene(R"({"circle": {"radius": -1}})"), "/bodies/0/shapes/0/circle/radius");
    check_invalid(R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"circle": {"radius": 1}}]}],
                      "joints": [{"type": "revolute", "bodies": ["a", "gone"], "anchor": [0, 0]}]})",
                  "gone");
}

TEST_CASE("an invalid scene is refused before any file is written") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", body_scene(R"({"circle": {"radius": -1}})"));
    CHECK(run_tumble({"run", scene, "-o", (folder / "out").string(), "--hashes", (folder / "h.csv").string()}).code ==
          3);
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
    CHECK_FALSE(std::filesystem::exists(folder / "h.csv"));
}

TEST_CASE("validate reports all errors of a scene") {
    const Folder folder;
    const std::string scene =
        folder.write("scene.json", body_scene(R"({"circle": {"radius": -1}}, {"box": {"size": [1]}}, {"capsul": {}})"));
    const Answer answer = run_tumble({"validate", scene});
    CHECK(answer.code == 3);
    for (const char* pointer : {"/shapes/0", "/shapes/1", "/shapes/2"}) {
        CAPTURE(pointer);
        CHECK_MESSAGE(answer.err.find(pointer) != std::string::npos, answer.err);
    }
}

TEST_CASE("a missing scene ends with exit code 4, and the message names it") {
    for (const char* command : {"run", "validate"}) {
        const Answer answer = run_tumble({command, "no/such/scene.json"});
        CHECK(answer.code == 4);
        CHECK(answer.err.find("no/such/scene.json") != std::string::npos);
    }
}

TEST_CASE("a folder that cannot be written ends with exit code 4, and the message names it") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const std::string file = folder.write("file", "");
    for (const std::string& target : {file + "/out", std::string("/proc/tumble")}) {
        CAPTURE(target);
        const Answer answer = run_tumble({"run", scene, "-o", target});
        CHECK(answer.code == 4);
        CHECK_MESSAGE(answer.err.find(target) != std::string::npos, answer.err);
    }
    const Answer answer =
        run_tumble({"run", scene, "--no-frames", "-o", (folder / "out").string(), "--hashes", file + "/h"});
    CHECK(answer.code == 4);
}

TEST_CASE("wrong arguments end with exit code 2") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const std::string out = (folder / "out").string(), csv = (folder / "data.csv").string();
    const std::vector<std::vector<std::string>> wrong = {
        {"flap"},
        {"run"},
        {"run", scene, "--no-such-option"},
        {"run", scene, "--size", "1280"},
        {"run", scene, "--size", "1x1"},
        {"run", scene, "--duration", "-1"},
        {"run", scene, "--duration", "nan"},
        {"run", scene, "--fps", "0"},
        {"shot", scene},
        {"shot", scene, "-o", (folder / "x.jpg").string()},
        {"run", scene, "--seed", "-3"},
        {"run", scene, "--seed", "1.5"},
        {"diff", scene, scene, "--tolerance", "nan"},
        {"plot", scene, "-o", csv},
        {"plot", scene, "energy"},
        {"plot", scene, "energy", "-o", (folder / "x.jpg").string()},
        {"plot", scene, "no_such_body.x", "-o", csv},
        {"plot", scene, "energy", "-o", csv, "--against", "1 +"},
        {"plot", scene, "energy", "time", "-o", (folder / "x.svg").string(), "--size", "400x200"},
        {"parity", "--seed", "-1"},
        {"parity", "--pairs", "99999999999999999999"},
        {"run", scene, "--overlay", "contacts,nothing"},
        {"demo", "no_such_demo"},
        {"demo", "../no_such_demo"},
        {"distance", R"({"circle": {"radius": 1}})"},
        {"distance", "--stdin", R"({"circle": {"radius": 1}})", R"({"circle": {"radius": 1}})"},
        {"run", scene, "--no-frames", "-o", out, "--trajectory", csv, "--contacts", csv},
        {"run", scene, "--no-frames", "-o", out, "--hashes", out + "/../out/events.csv"},
    };
    for (const std::vector<std::string>& arguments : wrong) {
        CAPTURE(arguments.back());
        const Answer answer = run_tumble(arguments);
        CHECK(answer.code == 2);
        CHECK(answer.out.empty());
        CHECK(answer.err.find("error") != std::string::npos);
    }
}

TEST_CASE("a misspelt command or option is answered with the nearest one") {
    CHECK(run_tumble({"rum", "x.json"}).err.find("unknown command 'rum'\n  hint: did you mean 'run'?") !=
          std::string::npos);
    CHECK(run_tumble({"run", "x.json", "--fsp", "2"})
              .err.find("unknown option '--fsp' of run\n  hint: did you mean '--fps'?") != std::string::npos);
    CHECK(run_tumble({"diff", "a", "b", "--heat"})
              .err.find("unknown option '--heat' of diff\n  hint: did you mean '--heat-map'?") != std::string::npos);
    CHECK(run_tumble({"rnu"}).err.find("hint: did you mean 'run'?") != std::string::npos);
    CHECK(run_tumble({"run", "x.json", "more"}).err.find("unknown argument 'more' of run") != std::string::npos);
}

TEST_CASE("an option without effect is a warning, and an existing file is refused before any file is written") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene()), out = (folder / "out").string();
    const std::string there = folder.write("there.csv", "");
    CHECK(run_tumble({"run", scene, "--no-frames", "-o", out, "--trajectory", there}).code == 4);
    CHECK_FALSE(std::filesystem::exists(out));
    const Answer idle =
        run_tumble({"run", scene, "--no-frames", "-o", out, "--fps", "3", "--jobs", "2", "--overlay", "contacts, all"});
    CHECK(idle.code == 0);
    CHECK(idle.err.find("--fps has no effect with --no-frames") != std::string::npos);
    CHECK(idle.err.find("--overlay has no effect") != std::string::npos);
    CHECK(idle.err.find("--jobs has no effect") != std::string::npos);
    CHECK(idle.err.find("--size") == std::string::npos);
}

TEST_CASE("--force replaces files only, not folders, pipes or devices") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene()), out = (folder / "out").string();
    const std::string pipe = (folder / "pipe").string();
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const auto run_with_hashes = [&](const std::string& file) {
        return run_tumble({"run", scene, "--no-frames", "--duration", "0.1", "--force", "-o", out, "--hashes", file});
    };
    CHECK(run_with_hashes(pipe).code == 4);
    CHECK(std::filesystem::is_fifo(pipe));
    CHECK(run_with_hashes(folder.path().string()).err.find("is a folder") != std::string::npos);
    CHECK(run_with_hashes(folder.write("hashes.csv", "")).code == 0);
}

TEST_CASE("a missing value, a missing scene and a misspelt demo are named") {
    CHECK(run_tumble({"run", "x.json", "--fps"}).err.find("--fps: the value is missing") != std::string::npos);
    CHECK(run_tumble({"run", "x.json", "--fps", "9", "--fps", "8"}).err.find("--fps: is given more than once") !=
          std::string::npos);
    CHECK(run_tumble({"bench", "--scenes", "piramid"}).err.find("piramid: no such file, and no shipped scene") !=
          std::string::npos);
    CHECK(run_tumble({"demo", "piramid"}).err.find("did you mean 'pyramid'?") != std::string::npos);
}

TEST_CASE("a run warns of bodies that have fallen below all static shapes") {
    const Folder folder;
    const std::string ground =
        R"({"format": 1, "world": {"duration": 4}, "bodies": [{"type": "static", "shapes": [{"box": {"size": [4, 1]}}]},
        {"name": "ball", "position": [X, 2], "shapes": [{"circle": {"radius": 0.5}}]}]})";
    const auto run_at = [&](const std::string& x) {
        std::string text = ground;
        const std::string scene = folder.write("s.json", text.replace(text.find("[X,") + 1, 1, x));
        return run_tumble({"run", scene, "--no-frames", "--force", "-o", (folder / "out").string()}).err;
    };
    CHECK(run_at("0").empty());
    // Four seconds at -10 m/s^2 from 2 m: -78 m, and the error of the integrator.
    CHECK(run_at("9").find("'ball' has fallen below all static and kinematic shapes: 'ball' is at y = -78.") !=
          std::string::npos);
}

TEST_CASE("a scene without a name gets the name of its file, and one without bodies is a warning") {
    const Folder folder;
    const std::string scene = folder.write("lonely.json", R"({"format": 1, "world": {"duration": 0.1}})");
    const Answer answer = run_tumble({"run", scene, "--no-frames", "-o", (folder / "out").string()});
    CHECK(answer.code == 0);
    CHECK(answer.out.starts_with("lonely: 6 steps"));
    CHECK(answer.err.find("has no bodies") != std::string::npos);
    CHECK(tumble::test::read_text(folder / "out/summary.json").find("\"scene\": \"lonely\"") != std::string::npos);
}

TEST_CASE("with --json an error is one document on standard output") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", body_scene(R"({"circle": {"radius": -1}})"));
    const Answer answer = run_tumble({"run", scene, "--json"});
    CHECK(answer.code == 3);
    CHECK(answer.out.find(R"("exit_code": 3)") != std::string::npos);
    CHECK(answer.out.find(R"("pointer": "/bodies/0/shapes/0/circle/radius")") != std::string::npos);
}
