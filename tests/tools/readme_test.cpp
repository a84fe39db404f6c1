// The distances that the README shows are those that the binary prints.
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

const std::string kReadme = read_text(TUMBLE_SOURCE_DIR "/README.md");

// The text between `from` and `to`, at their first occurrence behind `after`.
std::string between(const std::string& after, const std::string& from, const std::string& to) {
    const std::size_t start = kReadme.find(after);
    REQUIRE_MESSAGE(start != std::string::npos, after);
    const std::size_t begin = kReadme.find(from, start);
    REQUIRE_MESSAGE(begin != std::string::npos, from);
    const std::size_t end = kReadme.find(to, begin + from.size());
    REQUIRE_MESSAGE(end != std::string::npos, to);
    return kReadme.substr(begin + from.size(), end - begin - from.size());
}

}  // namespace

TEST_CASE("the binary answers the README's first distance and its line of JSON as shown") {
    const std::string a = between("run.sh distance ", "'", "' '"), b = between("run.sh distance ", "' '", "'\n");
    CHECK(run_tumble({"distance", a, b}).out == between("`distance` answers one query", "```\n", "```"));
    const std::string line = between("`distance --stdin` takes", "echo '", "' |");
    CHECK(Process(tumble_command({"distance", "--stdin"}), ".", line + "\n").wait().out ==
          between("run.sh distance --stdin", "```json\n", "```"));
}

TEST_CASE("the pentagon and the kite take the iterations and support vertices that the README states") {
    const Folder folder;
    const std::string trace = (folder / "gjk.json").string();
    const std::string a = between("support vertex of A in d minus", "distance '", "' \\\n"),
                      b = between("support vertex of A in d minus", "    '", "' \\\n");
    const Answer answer = run_tumble({"distance", a, b, "--trace", trace, "--json", "--sub-algorithm", "voronoi"});
    REQUIRE(answer.code == 0);
    CHECK(between("![A pentagon and a kite apart", ": ", " iterations") ==
          std::to_string(json::parse(read_text(trace))["steps"].size()));
    CHECK(between("![A pentagon and a kite apart", " iterations, ", " support vertices") ==
          std::to_string(json::parse(answer.out)["iterations"].get<int>()));
}
