// The distances on the page of GJK are those that the binary prints.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::Process;
using tumble::test::read_text;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

const std::string kGjkPage = read_text(TUMBLE_SOURCE_DIR "/src/narrow/GJK.md");

// The text between `from` and `to`, at their first occurrence behind `after`.
std::string between(const std::string& after, const std::string& from, const std::string& to) {
    const std::size_t start = kGjkPage.find(after);
    REQUIRE_MESSAGE(start != std::string::npos, after);
    const std::size_t begin = kGjkPage.find(from, start);
    REQUIRE_MESSAGE(begin != std::string::npos, from);
    const std::size_t end = kGjkPage.find(to, begin + from.size());
    REQUIRE_MESSAGE(end != std::string::npos, to);
    return kGjkPage.substr(begin + from.size(), end - begin - from.size());
}

}  // namespace

TEST_CASE("the first distance on the page of GJK and its line of JSON are those of the binary") {
    const std::string a = between("run.sh distance ", "'", "' '"), b = between("run.sh distance ", "' '", "'\n");
    CHECK(run_tumble({"distance", a, b}).out == between("It prints:", "```\n", "```"));
    const std::string line = between("`distance --stdin` reads", "echo '", "' |");
    CHECK(Process(tumble_command({"distance", "--stdin"}), ".", line + "\n").wait().out ==
          between("run.sh distance --stdin", "```json\n", "```"));
}

TEST_CASE("the pentagon and the kite take the iterations and support vertices that the page states") {
    const Folder folder;
    const std::string trace = (folder / "gjk.json").string();
    const std::string a = between("support point of A in d minus", "distance '", "' \\\n"),
                      b = between("support point of A in d minus", "    '", "' \\\n");
    const Answer answer = run_tumble({"distance", a, b, "--trace", trace, "--json"});
    REQUIRE(answer.code == 0);
    CHECK(between("![A pentagon and a kite apart", ": ", " iterations") ==
          std::to_string(json::parse(read_text(trace))["steps"].size() + 1));
    CHECK(json::parse(read_text(trace))["result"]["iterations"] == json::parse(answer.out)["iterations"]);
    CHECK(between("![A pentagon and a kite apart", " iterations, ", " support vertices") ==
          std::to_string(json::parse(answer.out)["iterations"].get<int>()));
    const std::string picture = (folder / "gjk.svg").string();
    REQUIRE(run_tumble({"distance", a, b, "--trace", picture}).out.find("\n  iterations  5\n") != std::string::npos);
    CHECK(read_text(picture).find(", 5 support vertices computed") != std::string::npos);
    CHECK(run_tumble({"distance", a, b}).out.find("\n  iterations  2\n") != std::string::npos);
}
