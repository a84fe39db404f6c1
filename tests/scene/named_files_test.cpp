// Paths in scenes stay in the folder of the file that names them.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "support/temporary_folder.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

std::string write(const fs::path& file, std::string_view text) {
    OutputFile output(file);
    output.write(text);
    output.commit();
    return file.string();
}

}  // namespace

TEST_CASE("a path leads outside by dots, as an absolute path, or through a symbolic link") {
    const TemporaryFolder folder;
    const fs::path inner = folder.path / "inner";
    fs::create_directories(inner / "deep");
    write(folder.path / "secret.json", "{}");
    fs::create_symlink(folder.path / "secret.json", inner / "link.json");
    fs::create_directory_symlink(folder.path, inner / "up");
    fs::create_symlink(inner / "loop.json", inner / "loop.json");
    for (const char* const named :
         {"a.json", "deep/a.json", "deep/../a.json", "missing/a.json", "./a.json", "..a.json"}) {
        CAPTURE(named);
        CHECK_FALSE(leads_outside(inner, named));
        CHECK_FALSE(leads_outside(inner, inner / named));
    }
    for (const char* const named : {"../secret.json", "deep/../../secret.json", "/etc/passwd", "link.json",
                                    "up/secret.json", "up/missing.json", "..", "../inner.json"}) {
        CAPTURE(named);
        CHECK(leads_outside(inner, named));
    }
    CHECK_FALSE(leads_outside("", "a.json"));
    CHECK(leads_outside("", "../a.json"));
    CHECK_FALSE(leads_outside(inner / "", "a.json"));
    // Through a link to the folder itself, the names in it are the same files.
    fs::create_directory_symlink(inner, folder.path / "again");
    CHECK_FALSE(leads_outside(folder.path / "again", inner / "a.json"));
}

TEST_CASE("a scene refuses included files, pictures and reference scenes outside its folder") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path / "inner");
    write(folder.path / "part.json", R"({"format": 1})");
    const std::string scene = write(folder.path / "inner/scene.json", R"({"format": 1,
        "include": [{"file": "../part.json"}],
        "expect": [{"picture": "../golden.png", "at": 0}, {"max_time_ratio": 1e6, "reference": "../part.json"}]})");
    std::string found;
    try {
        load_scene(scene);
    } catch (const SceneError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics) {
            CHECK(diagnostic.message == "leads out of the folder of this file");
            CHECK(diagnostic.hint == "--allow-outside permits it");
            CHECK(diagnostic.line > 0);
            found += diagnostic.pointer + " ";
        }
    }
    CHECK(found == "/include/0/file /expect/0/picture /expect/1/reference ");
    LoadOptions options;
    options.allow_outside = true;
    CHECK(load_scene(scene, options).expect.size() == 2);
    // The folder of a part counts for the paths in that part.
    write(folder.path / "inner/part.json", R"({"format": 1, "include": [{"file": "../part.json"}]})");
    const std::string outer =
        write(folder.path / "scene.json", R"({"format": 1, "include": [{"file": "inner/part.json"}]})");
    CHECK_THROWS_AS(load_scene(outer), SceneError);
    CHECK(load_scene(outer, options).bodies.empty());
}
