// Tables that compare tumble with Box2D state which versions they compare, and how each was compiled.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

TEST_CASE("every table names both engines, their versions and their builds") {
    const Folder folder;
    const std::string page = (folder / "page.html").string();
    const json about = json::parse(run_tumble({"--version", "--json"}).out);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"parity", "--pairs", "10", "--family", "near_gap"},
          std::vector<std::string>{"bench", "--pairs", "0", "--scenes", "pendulum", "--steps", "1", "--runs", "1"},
          std::vector<std::string>{"physics", "--row", "O1", "--short"}}) {
        CAPTURE(command[0]);
        std::vector<std::string> as_json = command, as_page = command;
        as_json.push_back("--json");
        const json engines = json::parse(run_tumble(as_json).out)["engines"];
        const std::string box2d = engines["box2d"]["version"].get<std::string>();
        CHECK(box2d.starts_with("2.4."));
        CHECK(engines["tumble"]["version"] == about["version"]);
        const std::string build = engines["tumble"]["build"].get<std::string>();
        CHECK(build.starts_with(about["compiler"].get<std::string>()));
        CHECK(build.find(about["simd"].get<std::string>() + " of this processor") != std::string::npos);
        const std::string of_box2d = engines["box2d"]["build"].get<std::string>();
        CHECK_FALSE(of_box2d.empty());
        if (of_box2d.starts_with("Debian")) CHECK(of_box2d.find(" " + box2d + "-") != std::string::npos);
        std::string lines = "tumble " + about["version"].get<std::string>() + ": " + build + "\nBox2D " + box2d + ": " +
                            of_box2d + "\n";
        if (engines.contains("box2d_v3"))
            lines += "Box2D v3 " + engines["box2d_v3"]["version"].get<std::string>() + ": " +
                     engines["box2d_v3"]["build"].get<std::string>() + "\n";
        CHECK(run_tumble(command).out.ends_with(lines));
        if (command[0] == "bench") continue;
        as_page.insert(as_page.end(), {"--report", page, "--force"});
        run_tumble(as_page);
        CHECK(read_text(page).find("Box2D " + box2d + ": ") != std::string::npos);
    }
}
