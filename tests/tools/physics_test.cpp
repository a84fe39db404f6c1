// `tumble physics`: its rows, JSON, table, page and errors.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::case_stride;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run_tumble;

namespace {

const json* find_row(const json& rows, const std::string& name) {
    for (const json& row : rows)
        if (row["name"] == name) return &row;
    return nullptr;
}

// The rows that miss their bars in the short form. A row that begins to hold leaves this list.
const std::set<std::string> kMissing{"G1", "G2", "I"};

}  // namespace

TEST_CASE("the short form of physics measures its rows in both engines, and its exit code says whether all hold") {
    std::vector<std::string> command{"physics", "--short", "--json"}, names;
    const json listed = json::parse(run_tumble({"physics", "--list", "--json"}).out);
    for (std::size_t i = 0; i < listed.size(); i += case_stride()) {
        names.push_back(listed[i]["name"]);
        command.insert(command.end(), {"--row", names.back()});
    }
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE((answer.code == 0 || answer.code == 7), answer.err);
    const json result = json::parse(answer.out);
    CHECK(result["short"] == true);
    CHECK(result["passed"] == (answer.code == 0));
    int holding = 0;
    for (const json& row : result["rows"]) {
        CAPTURE(row["name"].get<std::string>());
        CHECK(row["failure"] == "");
        bool holds = true;
        CHECK(row["findings"].size() >= 1);
        for (const json& finding : row["findings"]) {
            CHECK(finding["tumble"].size() >= 1);
            CHECK(finding["tumble"].size() == finding["at_step_end"].size());
            CHECK(finding["tumble"].size() == finding["box2d"].size());
            for (const json& value : finding["tumble"])
                holds = holds && value.is_number() &&
                        (finding["lower"].is_null() || value.get<double>() >= finding["lower"].get<double>()) &&
                        (finding["upper"].is_null() || value.get<double>() <= finding["upper"].get<double>());
        }
        CHECK(row["holds"] == holds);
        CHECK(holds == !kMissing.contains(row["name"].get<std::string>()));
        holding += holds;
    }
    CHECK(result["holding"] == holding);
    for (const std::string& name : names) CHECK_MESSAGE(find_row(result["rows"], name), name);
}

TEST_CASE("physics --list prints the rows, as JSON too") {
    const json rows = json::parse(run_tumble({"physics", "--list", "--json"}).out);
    for (const char* name :
         {"A1", "A2", "A3", "B1", "B2", "B3", "B4", "C",  "D",  "E",  "F1", "F2", "G1", "G2", "G3", "H", "I",
          "K",  "L1", "L2", "M",  "N",  "O1", "O2", "O3", "O4", "O5", "O6", "P1", "P2", "P3", "P4", "P5"})
        CHECK_MESSAGE(find_row(rows, name), name);
    const std::string text = run_tumble({"physics", "--list"}).out;
    for (const json& row : rows) CHECK(text.find(row["title"].get<std::string>() + "\n") != std::string::npos);
}

TEST_CASE("the report of physics is one self-contained page and is not overwritten") {
    const Folder folder;
    const std::string page = (folder / "physics.html").string();
    const std::vector<std::string> command = {"physics", "--row", "O3", "--row", "M", "--short", "--report", page};
    const Answer answer = run_tumble(command);
    REQUIRE_MESSAGE((answer.code == 0 || answer.code == 7), answer.err);
    CHECK(answer.out.find("O3  Disc that rolls down a slope: holds") != std::string::npos);
    CHECK(answer.out.find("A1") == std::string::npos);
    const std::string text = read_text(page);
    CHECK(text.find("<svg class=\"plot\"") != std::string::npos);
    CHECK(text.find("2/3 g sin(angle)") != std::string::npos);
    CHECK(text.find("prefers-color-scheme: dark") != std::string::npos);
    for (const char* from_elsewhere : {"<script", "src=", "href=", "url("})
        CHECK_MESSAGE(text.find(from_elsewhere) == std::string::npos, from_elsewhere);
    CHECK(run_tumble(command).code == 4);
    CHECK(read_text(page) == text);
}

TEST_CASE("physics refuses unknown rows") {
    const Answer answer = run_tumble({"physics", "--row", "Z9"});
    CHECK(answer.code == 2);
    CHECK(answer.err.find("there is no row 'Z9'; tumble physics --list names them all") != std::string::npos);
}
