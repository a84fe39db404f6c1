// `tumble shrink`: a crash of the simulation itself, and scenes that two builds simulate differently.
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "planted_failures.hpp"
#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::planted_failures;
using tumble::test::planted_scene;
using tumble::test::read_text;
using tumble::test::tumble_command;

namespace {

constexpr int kOtherBodies = 30;

// A library that ends a process when it allocates exactly this number of bytes, but not the one that loaded it: only
// the copies that simulate.
std::string crashing_library(const Folder& folder, std::size_t bytes) {
    const std::string source = folder.write("crash.cpp", R"(
#include <signal.h>
#include <stddef.h>
#include <unistd.h>
extern "C" void* __libc_malloc(size_t);
static const pid_t first = getpid();
extern "C" void* malloc(size_t bytes) {
    if (bytes == )" + std::to_string(bytes) + R"( && getpid() != first) raise(SIGSEGV);
    return __libc_malloc(bytes);
}
)");
    std::string library = (folder / "crash.so").string();
    const Answer answer =
        tumble::test::run({"/usr/bin/env", TUMBLE_COMPILER, "-shared", "-fPIC", "-o", library, source});
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    return library;
}

}  // namespace

TEST_CASE("a crash within the simulation shrinks to the body that crashes it") {
    // A sanitizer has a malloc of its own.
    if (std::string(TUMBLE_CXX_FLAGS).find("sanitize") != std::string::npos) return;
    const Folder folder;
    const std::string name(252, 'x');
    json scene = planted_scene(planted_failures().front(), kOtherBodies);
    scene["expect"] = json::array();
    scene["bodies"].push_back({{"name", name}, {"shapes", {{{"circle", {{"radius", 0.5}}}}}}});
    const std::string file = folder.write("scene.json", scene.dump());
    std::vector<std::string> command{"/usr/bin/env", "LD_PRELOAD=" + crashing_library(folder, name.size() + 1)};
    for (const std::string& word :
         tumble_command({"shrink", file, "--fails", "check", "-o", (folder / "min.json").string(), "--json"}))
        command.push_back(word);
    const Answer answer = tumble::test::run(command);
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json report = json::parse(answer.out);
    CHECK(report["after"]["bodies"] == 1);
    CHECK(report["failure"].get<std::string>().find("signal 11") != std::string::npos);
    CHECK(json::parse(read_text(folder / "min.json"))["bodies"][0]["name"] == name);
}

TEST_CASE("a scene that two builds simulate differently shrinks to what differs") {
    // The second build is this one with other joints, so that only what a joint holds differs.
    const Folder folder;
    const std::string tumble = tumble_command({}).front();
    const std::string script =
        folder.write("differ.sh", R"(hash() { ')" + tumble +
                                      R"(' run "$@" --no-frames --force -o "$1.out" --json | grep state_hash; }
one=$(hash "$1") && other=$(hash "$1" --set /world/joints=direct) && [ "$one" = "$other" ]
)");
    const std::string file = folder.write("scene.json", planted_scene(planted_failures().front(), kOtherBodies).dump());
    const Answer answer = tumble::test::run(tumble_command(
        {"shrink", file, "--fails", "sh " + script + " {}", "-o", (folder / "min.json").string(), "--json"}));
    REQUIRE_MESSAGE(answer.code == 0, answer.err);
    const json report = json::parse(answer.out);
    CHECK(report["before"]["bodies"] >= 24);
    CHECK(report["after"]["bodies"] <= 3);
    CHECK(report["after"]["joints"] == 1);
}
