// The installed package is found by CMake, and the example on the library's page compiles and runs.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"

namespace fs = std::filesystem;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::read_text;
using tumble::test::run;

namespace {

void check(const std::vector<std::string>& command) {
    const Answer answer = run(command);
    REQUIRE_MESSAGE(answer.code == 0, command.front() << " " << command[1] << "\n" << answer.out << answer.err);
}

// The first ```cpp block of include/tumble/README.md.
std::string page_example() {
    const std::string page = read_text(TUMBLE_SOURCE_DIR "/include/tumble/README.md");
    const std::string fence = "```cpp\n";
    const std::size_t start = page.find(fence);
    REQUIRE(start != std::string::npos);
    const std::size_t end = page.find("```", start + fence.size());
    REQUIRE(end != std::string::npos);
    return page.substr(start + fence.size(), end - start - fence.size());
}

constexpr const char* kTenLines = R"(
#include <tumble/world.hpp>
int main() {
    tumble::World world;
    const tumble::BodyId ball = world.create_body({.pose = {{0.0, 10.0}, {}}});
    world.add_shape(ball, {.shape = tumble::make_circle(0.5f)});
    for (int i = 0; i < 60; ++i) world.step();
    // A second of free fall is 5 m, within half a step of the integrator.
    const double y = world.state(ball).pose.position.y;
    return 4.9 < y && y < 5.1 ? 0 : 1;
}
)";

constexpr const char* kListFile = R"(
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(tumble 0.2 REQUIRED)
add_executable(ten_lines ten_lines.cpp)
target_link_libraries(ten_lines PRIVATE tumble::tumble)
add_executable(page_example page_example.cpp)
target_link_libraries(page_example PRIVATE tumble::render)
)";

}  // namespace

TEST_CASE("a separate project finds the installed package, links it and runs") {
    const Folder folder;
    const std::string prefix = (folder / "prefix").string();
    const std::string build = (folder / "build").string();
    check({"cmake", "--install", TUMBLE_BINARY_DIR, "--prefix", prefix});
    folder.write("CMakeLists.txt", kListFile);
    folder.write("ten_lines.cpp", kTenLines);
    folder.write("page_example.cpp", page_example());
    check({"cmake", "-S", folder.path().string(), "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
           "-DCMAKE_PREFIX_PATH=" + prefix, std::string("-DCMAKE_CXX_COMPILER=") + TUMBLE_COMPILER,
           std::string("-DCMAKE_CXX_FLAGS=") + TUMBLE_CXX_FLAGS});
    check({"cmake", "--build", build});
    CHECK(run({build + "/ten_lines"}).code == 0);
    const Answer example = run({build + "/page_example"}, TUMBLE_SOURCE_DIR);
    CHECK_MESSAGE(example.code == 0, example.out << example.err);

    const Answer installed = run({prefix + "/bin/tumble", "demo", "--list"});
    CHECK_MESSAGE(installed.code == 0, installed.err);
    CHECK(installed.out.find("pyramid") != std::string::npos);
    CHECK(fs::exists(fs::path(prefix) / "share/tumble/scenes/pyramid.json"));
}
