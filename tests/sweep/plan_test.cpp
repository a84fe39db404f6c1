// The plans that are shipped, and the schema of plans.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../scene/schema_validator.hpp"
#include "sweep/plan/plan.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using namespace tumble;

namespace {

const fs::path kPlans = fs::path(TUMBLE_SOURCE_DIR) / "scenes/plans";

std::string read_text(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Whether the reader accepts a plan, with scenes of any folder.
bool reads(const json& plan) {
    const fs::path file = fs::temp_directory_path() / ("tumble_plan_" + std::to_string(::getpid()) + ".json");
    std::ofstream(file) << plan.dump();
    bool is_read = true;
    try {
        sweep::read_plan(file, 0, true);
    } catch (const SceneError&) {
        is_read = false;
    }
    fs::remove(file);
    return is_read;
}

}  // namespace

TEST_CASE("plan.schema.json is the schema of this version, and the shipped plans are valid") {
    CHECK(read_text(kPlans / "plan.schema.json") == sweep::plan_schema());
    test::SchemaValidator schema(json::parse(sweep::plan_schema()));
    int plans = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(kPlans)) {
        if (!entry.path().string().ends_with(".plan.json")) continue;
        CAPTURE(entry.path());
        CHECK(schema.accepts_text(read_text(entry.path())));
        std::vector<Diagnostic> warnings;
        const sweep::Plan plan = sweep::read_plan(entry.path(), 0, false, &warnings);
        CHECK(warnings.empty());
        CHECK(entry.path().filename() == plan.name + ".plan.json");
        CHECK(plan.runs > 0);
        ++plans;
    }
    CHECK(plans == 5);
}

TEST_CASE("the scenes of the plans are valid without warnings") {
    for (const fs::directory_entry& entry : fs::directory_iterator(kPlans)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".json") || name.ends_with(".plan.json") || name == "plan.schema.json") continue;
        CAPTURE(name);
        std::vector<Diagnostic> warnings;
        LoadOptions options;
        options.lint = true;
        const Scene scene = load_scene(entry.path(), options, &warnings);
        CHECK(scene.name + ".json" == name);
        CHECK(warnings.empty());
    }
}

TEST_CASE("the schema and the reader accept and refuse the same plans") {
    test::SchemaValidator schema(json::parse(sweep::plan_schema()));
    const json plan = {{"format", 1},
                       {"scene", (kPlans / "tower_and_ball.json").string()},
                       {"runs", 5},
                       {"set", {{"/world/duration", 1}}},
                       {"seeds", {{"first", 3}, {"count", 2}}},
                       {"sampling", "sobol"},
                       {"parameters",
                        {{{"name", "x"}, {"set", "/bodies/ball/position/0"}, {"range", {0, 1}}, {"whole", true}},
                         {{"name", "y"}, {"set", {"/bodies/ball/position/1"}}, {"normal", {5, 0.1}}},
                         {{"name", "l"}, {"log_range", {1, 2}}, {"count", 3}},
                         {{"name", "c"}, {"choice", {1, "two", nullptr}}},
                         {{"name", "k"}, {"list", {1, 2}}}}},
                       {"measures", {{{"name", "m"}, {"value", "ball.x + l"}}}},
                       {"filter", {{"claims", true}, {"that", "ball.y > 0"}}},
                       {"write",
                        {{"trajectory", {{"every", 2}, {"as", "npy"}, {"bits", 64}}},
                         {"events", true},
                         {"frames", {{"every", 5}, {"size", {64, 48}}, {"plain", true}}},
                         {"masks", {{"every", 5}, {"size", {64, 48}}}}}},
                       {"shard_runs", 2},
                       {"timeout", 3}};
    CHECK(schema.accepts(plan));
    CHECK(reads(plan));
    const std::vector<std::pair<std::string, json>> wrong = {
        {"/format", 2},
        {"/format", "1"},
        {"/scene", 3},
        {"/scenes", json::array({"a.json"})},
        {"/runs", 0},
        {"/runs", 1.5},
        {"/runs", -1},
        {"/runs", 1e300},
        {"/seed", -1},
        {"/seeds", json::array()},
        {"/seeds", "all"},
        {"/seeds/frist", 1},
        {"/sampling", "grid"},
        {"/set", json::array()},
        {"/parameters", 1},
        {"/parameters/0/range", 3},
        {"/parameters/0/range", {1, 2, 3}},
        {"/parameters/0/count", 0},
        {"/parameters/0/whole", 1},
        {"/parameters/0/list", {1}},
        {"/parameters/1/name", "a b"},
        {"/parameters/1/name", ""},
        {"/parameters/1/nmae", "a"},
        {"/parameters/4/list", json::array()},
        {"/measures/0/value", 1},
        {"/measures/0/unit", "m"},
        {"/filter/claims", "yes"},
        {"/filter/claim", true},
        {"/write/events", 1},
        {"/write/frames", true},
        {"/write/frames/every", 0},
        {"/write/frames/size", {64, 15}},
        {"/write/frames/size", {4097, 64}},
        {"/write/frames/size", {64.5, 64}},
        {"/write/frames/size", {1e300, 64}},
        {"/write/frames/size", 64},
        {"/write/masks/plain", true},
        {"/write/trajectory/every", 0},
        {"/write/trajectory/as", "csv"},
        {"/write/trajectory/bits", 16},
        {"/shard_runs", 0},
        {"/timeout", 0},
        {"/rnus", 3},
    };
    for (const auto& change : wrong) {
        const std::string pointer = change.first;
        const json value = change.second;
        json changed = plan;
        changed[json::json_pointer(pointer)] = value;
        CAPTURE(pointer);
        CAPTURE(value.dump());
        CHECK_FALSE(schema.accepts(changed));
        CHECK_FALSE(reads(changed));
    }
}

TEST_CASE("a plan names scenes outside its folder only if that is allowed") {
    const fs::path folder = fs::temp_directory_path() / ("tumble_plans_" + std::to_string(::getpid()));
    fs::create_directories(folder / "plans/deep");
    for (const char* const scene : {"scene.json", "plans/deep/scene.json"})
        std::ofstream(folder / scene) << R"({"format": 1})";
    const fs::path file = folder / "plans/plan.json";
    std::ofstream(file) << R"({"format": 1, "scenes": ["deep/scene.json", "../scene.json"]})";
    std::string found;
    try {
        sweep::read_plan(file);
    } catch (const SceneError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics) found += diagnostic.pointer + ": " + diagnostic.message;
    }
    CHECK(found == "/scenes/1: leads out of the folder of this file");
    CHECK(sweep::read_plan(file, 0, true).runs == 2);
    fs::remove_all(folder);
}

TEST_CASE("ranges that are too wide, and whole ranges without whole ends, are refused at their key") {
    const auto error_of = [](const std::string& parameter) {
        const fs::path file = fs::temp_directory_path() / ("tumble_range_" + std::to_string(::getpid()) + ".json");
        std::ofstream(file) << R"({"format": 1, "scene": ")" << (kPlans / "tower_and_ball.json").string()
                            << R"(", "runs": 2, "parameters": [{"name": "p", )" << parameter << "}]}";
        std::string found;
        try {
            sweep::read_plan(file, 0, true);
        } catch (const SceneError& error) {
            found = error.diagnostics.at(0).pointer;
        }
        fs::remove(file);
        return found;
    };
    CHECK(error_of(R"("range": [0, 2], "whole": true)").empty());
    CHECK(error_of(R"("log_range": [1e-300, 1e300])").empty());
    CHECK(error_of(R"("range": [-1.7e308, 1.7e308])") == "/parameters/0/range");
    CHECK(error_of(R"("normal": [1e308, 1e308])") == "/parameters/0/normal");
    CHECK(error_of(R"("range": [0.5, 2.5], "whole": true)") == "/parameters/0/range");
    CHECK(error_of(R"("range": [0, 1e300], "whole": true)") == "/parameters/0/range");
    CHECK(error_of(R"("range": [1, 2], "whole": true, "count": 5)") == "/parameters/0/count");
    CHECK(error_of(R"("range": [1, 2], "whole": true, "count": 2)").empty());
}
