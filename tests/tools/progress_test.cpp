// The bar of long commands, and --quiet.
#include <doctest/doctest.h>

#include <string>

#include "process.hpp"
#include "tools/cli/console.hpp"

using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;
using tumble::tools::progress_text;

TEST_CASE("the bar has the share that is done, the rate, and the time left at that rate") {
    // 300 in 10 s are 30 a second; 900 are left.
    CHECK(progress_text("steps", 300, 1200, 10.0) ==
          "[######------------------] 300 of 1200 steps, 30 per second, 30 s left");
    CHECK(progress_text("scenes", 1, 40, 2.0) ==
          "[------------------------] 1 of 40 scenes, 0.5 per second, 78 s left");
    CHECK(progress_text("runs", 0, 9, 3.0) == "[------------------------] 0 of 9 runs, 0.0 per second, 0 s left");
    CHECK(progress_text("runs", 9, 9, 3.0) == "[########################] 9 of 9 runs, 3.0 per second, 0 s left");
}

TEST_CASE("--quiet leaves out the report, and neither documents nor errors") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", R"({"format": 1, "world": {"duration": 0.1}, "bodies": [
        {"name": "ball", "shapes": [{"circle": {"radius": 0.5}}]}], "expect": [{"that": "ball.y > 5"}]})");
    CHECK(!run_tumble({"check", scene}).out.empty());
    const Answer quiet = run_tumble({"check", scene, "--quiet"});
    CHECK(quiet.code == 7);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
    CHECK(run_tumble({"check", scene, "-q", "--json"}).out.find("ball.y > 5") != std::string::npos);
    CHECK(run_tumble({"fmt", scene, "-q"}).out.find("\"ball\"") != std::string::npos);
    CHECK(run_tumble({"check", (folder / "none.json").string(), "-q"}).code == 4);
    const Answer run = run_tumble({"run", scene, "-q", "--no-frames", "-o", (folder / "out").string()});
    CHECK(run.code == 0);
    CHECK(run.out.empty());
}
