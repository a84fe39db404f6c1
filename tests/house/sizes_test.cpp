// Folders, files and functions that are small enough to be understood in one reading.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "house/files.hpp"
#include "house/functions.hpp"

namespace {

using namespace tumble::test;

constexpr int kLongestFunction = 91;
constexpr int kLongestFile = 377;
constexpr int kLargestFolder = 30;

}  // namespace

TEST_CASE("no folder has more than 30 sources") {
    std::map<std::string, int> counts;
    for (const auto& file : files_below({"src", "tools", "include"}, {".cpp", ".hpp"}))
        ++counts[name_in_project(file.parent_path())];
    CHECK(counts.size() > 50);
    for (const auto& counted : counts) CHECK_MESSAGE(counted.second <= kLargestFolder, counted.first);
}

TEST_CASE("no file has more than 377 lines") {
    const auto files =
        files_below({"src", "tools", "include", "tests"}, {".cpp", ".hpp", ".js", ".py", ".sh", ".cmake"});
    CHECK(files.size() > 1000);
    for (const auto& file : files) {
        const std::string text = text_in(file);
        CHECK_MESSAGE(std::count(text.begin(), text.end(), '\n') <= kLongestFile, name_in_project(file));
    }
}

TEST_CASE("no function has more than 91 lines") {
    std::size_t count = 0;
    for (const auto& file : files_below({"src", "tools", "include"}, {".cpp", ".hpp"}))
        for (const Function& function : functions_of(text_in(file))) {
            ++count;
            CHECK_MESSAGE(function.length <= kLongestFunction, name_in_project(file)
                                                                   << ":" << function.line << ": " << function.head);
        }
    CHECK(count > 5000);
}

TEST_CASE("functions are found in namespaces and types, with their lines, whatever their texts contain") {
    const std::vector<Function> found = functions_of(R"sample(
#define OPEN(x) { \
    x
namespace a {  // not a function: {
struct alignas(8) B {
    int member{1};
    explicit B(int x) : member{x}, other_{'{'}, million_{1'000} {
        if (x) { member = 2; }
    }
private:
    const char* text() const { return "}\"{"; }
};
const int kTable[] = {
    f(1),
};
template <class T, class U = C<int>>
T g(T t) {
    const auto h = [] { return R"({{{)"; };  /* } */
    return t;
}
}
)sample");
    REQUIRE(found.size() == 3);
    CHECK(found[0].line == 7);
    CHECK(found[0].length == 3);
    CHECK(found[1].head == "const char* text() const");
    CHECK(found[1].length == 1);
    CHECK(found[2].line == 16);
    CHECK(found[2].length == 5);
}
