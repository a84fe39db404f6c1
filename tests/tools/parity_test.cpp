// `tumble parity`: its JSON, table, page and errors.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

TEST_CASE("parity prints the JSON of the contract, and no answer of tumble is wrong") {
    const Answer answer = run_tumble(
        {"parity", "--pairs", "2000", "--seed", "7", "--family", "near_gap", "--family", "far_16km", "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json result = json::parse(answer.out);
    CHECK(result["pairs"] == 2000);
    CHECK(result["seed"] == 7);
    CHECK(result["ours_wrong"] == 0);
    CHECK(result["box2d_wrong"].get<int>() > 100);
    CHECK(result["checked_exactly"].get<int>() >= 2000);
    REQUIRE(result["families"].size() == 2);
    const json& family = result["families"][1];
    CHECK(family["name"] == "far_16km");
    CHECK(family["pairs"] == 1000);
    for (const char* key : {"ours_wrong", "box2d_wrong", "ill_conditioned", "max_error_ours_m", "max_error_ours_units",
                            "max_error_box2d_m", "max_error_box2d_eps"})
        CHECK_MESSAGE(family[key].is_number(), key);
    CHECK(family["max_error_ours_units"].get<double>() > 0.1);
    CHECK(family["max_error_ours_units"].get<double>() < 16.0);
    CHECK(family["max_error_box2d_m"].get<double>() > 1e-4);  // 16 km rounded to float: 1 mm
}

TEST_CASE("parity of a scene compares its pairs step by step") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", tumble::test::small_scene());
    const Answer answer = run_tumble({"parity", "--scene", scene, "--json"});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json result = json::parse(answer.out);
    CHECK(result["families"][0]["name"] == "small");
    CHECK(result["ours_wrong"] == 0);
    CHECK(result["pairs"].get<int>() > 300);  // two bodies on the ground for most of 300 steps
    CHECK(run_tumble({"parity", "--scene", scene, "--seed", "2"}).err.find("--seed has no effect with --scene") !=
          std::string::npos);
    const std::string nameless = folder.write("nameless.json", R"({"format": 1, "world": {"duration": 0.1}})");
    CHECK(json::parse(run_tumble({"parity", "--scene", nameless, "--json"}).out)["families"][0]["name"] == "nameless");
}

TEST_CASE("parity --list prints the families, as JSON too") {
    const json families = json::parse(run_tumble({"parity", "--list", "--json"}).out);
    REQUIRE(families.size() > 20);
    const std::string text = run_tumble({"parity", "--list"}).out;
    for (const json& family : families) CHECK(text.find(family["name"].get<std::string>() + " ") != std::string::npos);
}

TEST_CASE("the parity report is one self-contained page and is not overwritten") {
    const Folder folder;
    const std::string page = (folder / "report.html").string();
    const std::vector<std::string> command = {"parity", "--pairs", "500", "--family", "near_overlap", "--report", page};
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    CHECK(answer.out.find("near_overlap") != std::string::npos);
    const std::string text = read_text(page);
    CHECK(text.find("<svg") != std::string::npos);
    CHECK(text.find("Wrong answers of Box2D: the worst of each family") != std::string::npos);
    CHECK(text.find("overlap flag") != std::string::npos);
    for (const char* from_elsewhere : {"<script", "src=", "href=", "url("})
        CHECK_MESSAGE(text.find(from_elsewhere) == std::string::npos, from_elsewhere);
    CHECK(run_tumble(command).code == 4);
    CHECK(read_text(page) == text);
}

TEST_CASE("parity refuses unknown families and invalid numbers of pairs") {
    const Answer families = run_tumble({"parity", "--list"});
    CHECK(families.code == 0);
    CHECK(families.out.find("near_gap") != std::string::npos);
    const Answer unknown = run_tumble({"parity", "--family", "near_gapp"});
    CHECK(unknown.code == 2);
    CHECK(unknown.err.find("near_gapp") != std::string::npos);
    CHECK(run_tumble({"parity", "--pairs", "0"}).code == 2);
    CHECK(run_tumble({"parity", "--scene", "no_such_scene.json"}).code == 4);
}
