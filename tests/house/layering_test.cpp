// Reads the #include lines of the whole project and fails on an upward include, or on a third-party header outside
// its room. The tables here and in walls.hpp are the design's, and the README's page on the rooms shows the same.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "house/walls.hpp"

namespace fs = std::filesystem;

namespace {

using tumble::test::first_folder;
using tumble::test::folder_of_source;
using tumble::test::kMaySee;
using tumble::test::may_include;

const fs::path root = tumble::test::kProject;

struct Include {
    fs::path file;
    int line = 0;
    std::string target;
    bool quoted = false;
};

std::vector<Include> read_includes(const fs::path& file) {
    std::vector<Include> includes;
    std::ifstream in(file);
    std::string text;
    for (int line = 1; std::getline(in, text); ++line) {
        const std::size_t keyword = text.find_first_not_of(" \t");
        if (keyword == std::string::npos || text.compare(keyword, 8, "#include") != 0) continue;
        const std::size_t open = text.find_first_of("<\"", keyword + 8);
        if (open == std::string::npos) continue;
        const bool quoted = text[open] == '"';
        const std::size_t close = text.find(quoted ? '"' : '>', open + 1);
        includes.push_back({file, line, text.substr(open + 1, close - open - 1), quoted});
    }
    return includes;
}

std::vector<Include> includes_below(const fs::path& folder) {
    std::vector<Include> all;
    if (!fs::exists(folder)) return all;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".hpp") continue;
        const std::vector<Include> found = read_includes(entry.path());
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

std::string text_of(const Include& include) {
    return fs::relative(include.file, root).string() + ":" + std::to_string(include.line) + " includes " +
           include.target;
}

// Public headers that a lower room may include; a room that is not listed may include all of them.
const std::map<std::string, std::set<std::string>> kPublicHeaders = {
    {"file", {"file.hpp"}},
    {"math", {"math.hpp"}},
    {"simd", {"math.hpp", "instruction_set.hpp"}},
    {"shape", {"math.hpp", "shape.hpp", "outline.hpp"}},
    {"narrow", {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp"}},
    {"tasks", {"threads.hpp"}},
    {"broad", {"math.hpp", "threads.hpp"}},
    {"dynamics",
     {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp", "id.hpp",
      "body.hpp", "joint.hpp", "world_def.hpp", "events.hpp", "counters.hpp", "threads.hpp"}},
};

// Third-party headers by their first folder or whole name, and the rooms that may include them.
const std::map<std::string, std::set<std::string>> kThirdParty = {
    {"Eigen", {"simd", "dynamics", "reference", "include"}},
    {"GL", {"render"}},
    {"stb_image.h", {"render"}},
    {"isa-l", {"render"}},
    {"stb_truetype.h", {"render"}},
    {"libdeflate.h", {"render"}},
    {"turbojpeg.h", {"render"}},
    {"nlohmann", {"scene", "import", "render", "tools", "reference", "sweep"}},
    {"pybind11", {"python"}},
    {"rapidjson", {"tools"}},
    {"libfccp", {"tools"}},
    {"CLI", {"tools"}},
    {"xxhash.h", {"dynamics", "world", "scene", "tools", "sweep"}},
    {"hdf5.h", {"sweep"}},
    {"box2d", {"reference"}},
    {"gmp.h", {"reference"}},
    {"gmpxx.h", {"reference"}},
    {"pugixml.hpp", {"import"}},
    {"tbb", {"tasks"}},
};

void check_third_party(const Include& include, const std::string& room) {
    const auto found = kThirdParty.find(first_folder(include.target));
    if (found == kThirdParty.end()) return;
    if (room == "include" && include.file.filename() != "eigen.hpp") {
        FAIL_CHECK(text_of(include));
        return;
    }
    if (!found->second.contains(room)) FAIL_CHECK(text_of(include));
}

std::string folder_of(const std::string& target) { return fs::path(target).parent_path().generic_string(); }

void check_public(const Include& include, const std::string& room) {
    const auto allowed = kPublicHeaders.find(room);
    if (allowed != kPublicHeaders.end() && !allowed->second.contains(include.target.substr(7)))
        FAIL_CHECK(text_of(include));
}

// True if includes can lead from a folder back to it.
bool leads_back(const std::string& start, const std::string& folder, std::set<std::string>& seen) {
    for (const auto& [target, unused] : kMaySee) {
        if (target == folder || !may_include(folder, target)) continue;
        if (target == start) return true;
        if (seen.insert(target).second && leads_back(start, target, seen)) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("folders include only what the table allows") {
    int checked = 0;
    for (const char* top : {"src", "tools"})
        for (const Include& include : includes_below(root / top)) {
            ++checked;
            const std::string folder = folder_of_source(include.file), room = first_folder(folder);
            REQUIRE_MESSAGE(kMaySee.contains(folder), "the folder " << folder << " is not in the table");
            check_third_party(include, room);
            const std::string target = folder_of(include.target);
            if (target == "tumble")
                check_public(include, room);
            else if (include.quoted && !may_include(folder, target))
                FAIL_CHECK(text_of(include));
        }
    CHECK(checked > 1000);
}

TEST_CASE("the table has no circle") {
    for (const auto& wall : kMaySee) {
        std::set<std::string> seen;
        CHECK_MESSAGE(!leads_back(wall.first, wall.first, seen), wall.first);
    }
}

TEST_CASE("public headers include the standard library and each other only") {
    int checked = 0;
    for (const Include& include : includes_below(root / "include")) {
        ++checked;
        check_third_party(include, "include");
        if (include.quoted && first_folder(include.target) != "tumble") FAIL_CHECK(text_of(include));
    }
    CHECK(checked > 50);
}

TEST_CASE("tests compare with tolerances that they state, not with those that doctest adds") {
    const std::string word = std::string("Appr") + "ox";
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "tests")) {
        const fs::path extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".hpp") continue;
        std::ifstream in(entry.path());
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        CHECK_MESSAGE(text.find(word) == std::string::npos, fs::relative(entry.path(), root).string());
    }
}
