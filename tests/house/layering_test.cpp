// Reads the #include lines of the whole project and fails on an upward include, or on a third-party header outside
// its room. The tables below are the design's, and the README's page on the rooms shows the same.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

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

std::string first_folder(const std::string& path) { return path.substr(0, path.find('/')); }

std::string place(const Include& include) {
    return fs::relative(include.file, TUMBLE_SOURCE_DIR).string() + ":" + std::to_string(include.line) + " includes " +
           include.target;
}

const fs::path root = TUMBLE_SOURCE_DIR;

// What each folder may include besides its own files, debug and public headers. A name stands for a folder and all
// below it.
const std::map<std::string, std::set<std::string>> kMaySee = {
    {"debug", {}},
    {"file", {}},
    {"math", {}},
    {"simd", {"math"}},
    {"shape", {"math"}},
    {"broad", {"math"}},
    {"narrow/cores", {"math", "simd", "shape"}},
    {"narrow/gjk", {"narrow/cores"}},
    {"narrow/faces", {"simd", "narrow/cores", "narrow/gjk"}},
    {"narrow/distance", {"simd", "narrow/cores", "narrow/gjk", "narrow/faces"}},
    {"narrow/manifold", {"shape", "narrow/cores", "narrow/distance"}},
    {"narrow/cast", {"simd", "narrow/cores"}},
    {"narrow/impact", {"math", "narrow/cores", "narrow/distance", "narrow/cast"}},
    {"narrow/compound", {"narrow/cores", "narrow/distance", "narrow/cast"}},
    {"dynamics/bodies", {"math", "broad"}},
    {"dynamics/contacts", {"simd", "broad", "narrow/manifold", "dynamics/bodies"}},
    {"dynamics/rows", {"dynamics/bodies"}},
    {"dynamics/joints", {"dynamics/bodies", "dynamics/rows"}},
    {"dynamics/state", {"broad", "dynamics/bodies", "dynamics/contacts", "dynamics/rows", "dynamics/joints"}},
    {"dynamics/stages", {"dynamics/bodies", "dynamics/contacts", "dynamics/state"}},
    {"dynamics", {"dynamics/bodies", "dynamics/contacts", "dynamics/state", "dynamics/stages"}},
    {"world", {"dynamics"}},
    {"scene/json", {}},
    {"scene/format", {"scene/json"}},
    {"scene/model", {"scene/json", "scene/format"}},
    {"scene/claims", {"scene/json", "scene/format", "scene/model"}},
    {"scene/build", {"scene/json", "scene/format", "scene/model", "scene/claims"}},
    {"scene/lint", {"scene/json", "scene/model", "scene/build"}},
    {"scene/load", {"scene/json", "scene/format", "scene/model", "scene/claims", "scene/build", "scene/lint"}},
    {"scene/run", {"scene/json", "scene/model"}},
    {"import/rube", {"scene/json", "scene/format", "scene/model"}},
    {"import/svg", {"scene/json", "scene/format", "scene/model"}},
    {"render/style", {}},
    {"render/view", {}},
    {"render/canvas", {"render/style"}},
    {"render/shapes", {"render/style", "render/view", "render/canvas"}},
    {"render/frame", {"render/style", "render/view", "render/canvas", "render/shapes"}},
    {"render/drawing", {"render/view", "render/canvas", "render/shapes"}},
    {"render/output", {}},
    {"reference/query", {}},
    {"reference/exact", {"reference/query"}},
    {"reference/box2d", {"reference/query"}},
    {"reference/bench", {"reference/query", "reference/box2d"}},
    {"reference/families", {"reference/query", "reference/exact", "reference/box2d"}},
    {"reference/parity", {"reference/query", "reference/exact", "reference/box2d", "reference/families"}},
    {"tools/output", {}},
    {"tools/cli", {"tools/output"}},
    {"tools/query", {"tools/output", "tools/cli"}},
    {"tools/measure", {"tools/output", "reference"}},
    {"tools/parity", {"tools/output", "reference"}},
    {"tools/run", {"tools/output", "tools/cli", "tools/measure"}},
    {"tools/scene", {"tools/output", "tools/cli", "tools/measure", "tools/run"}},
    {"tools/commands",
     {"tools/output", "tools/cli", "tools/query", "tools/measure", "tools/parity", "tools/run", "tools/scene",
      "reference"}},
    {"tools", {"tools/cli"}},
};

// Public headers that a lower room may include; rooms not named here may include all of them.
const std::map<std::string, std::set<std::string>> kPublicHeaders = {
    {"file", {"file.hpp"}},
    {"math", {"math.hpp"}},
    {"simd", {"math.hpp"}},
    {"shape", {"math.hpp", "shape.hpp", "outline.hpp"}},
    {"narrow",
     {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp",
      "chain_manifold.hpp"}},
    {"broad", {"math.hpp"}},
    {"dynamics",
     {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp",
      "chain_manifold.hpp", "id.hpp", "body.hpp", "joint.hpp", "events.hpp", "counters.hpp"}},
};

// Third-party headers by their first folder or whole name, and the rooms that may include them.
const std::map<std::string, std::set<std::string>> kThirdParty = {
    {"Eigen", {"simd", "dynamics", "reference", "include"}},
    {"GL", {"render"}},
    {"stb_image_write.h", {"render"}},
    {"stb_truetype.h", {"render"}},
    {"libdeflate.h", {"render"}},
    {"nlohmann", {"scene", "import", "tools", "reference"}},
    {"rapidjson", {"tools"}},
    {"libfccp", {"tools"}},
    {"CLI", {"tools"}},
    {"xxhash.h", {"world", "scene"}},
    {"box2d", {"reference"}},
    {"gmp.h", {"reference"}},
    {"gmpxx.h", {"reference"}},
    {"pugixml.hpp", {"import"}},
};

void check_third_party(const Include& include, const std::string& room) {
    const auto found = kThirdParty.find(first_folder(include.target));
    if (found == kThirdParty.end()) return;
    if (room == "include" && include.file.filename() != "eigen.hpp") {
        FAIL_CHECK(place(include));
        return;
    }
    if (!found->second.contains(room)) FAIL_CHECK(place(include));
}

// The folder of a source as the table names it: below src without that name, tools with it.
std::string folder_of(const fs::path& file) {
    const std::string folder = fs::relative(file.parent_path(), root).generic_string();
    return folder.starts_with("src/") ? folder.substr(4) : folder;
}

std::string folder_of(const std::string& target) { return fs::path(target).parent_path().generic_string(); }

bool is_in(const std::string& folder, const std::string& above) {
    return folder == above || folder.starts_with(above + "/");
}

bool may_include(const std::string& folder, const std::string& target) {
    if (folder == target || target == "debug") return true;
    for (const std::string& seen : kMaySee.at(folder))
        if (is_in(target, seen)) return true;
    return false;
}

void check_public(const Include& include, const std::string& room) {
    const auto allowed = kPublicHeaders.find(room);
    if (allowed != kPublicHeaders.end() && !allowed->second.contains(include.target.substr(7)))
        FAIL_CHECK(place(include));
}

// Folders with the number of sources directly in them.
std::map<std::string, int> count_sources() {
    std::map<std::string, int> counts;
    for (const char* top : {"src", "tools", "include"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const fs::path extension = entry.path().extension();
            if (extension == ".cpp" || extension == ".hpp")
                ++counts[fs::relative(entry.path().parent_path(), root).generic_string()];
        }
    return counts;
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
            const std::string folder = folder_of(include.file), room = first_folder(folder);
            REQUIRE_MESSAGE(kMaySee.contains(folder), "the folder " << folder << " is not in the table");
            check_third_party(include, room);
            const std::string target = folder_of(include.target);
            if (target == "tumble")
                check_public(include, room);
            else if (include.quoted && !may_include(folder, target))
                FAIL_CHECK(place(include));
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
    for (const Include& include : includes_below(root / "include")) {
        check_third_party(include, "include");
        if (include.quoted && first_folder(include.target) != "tumble") FAIL_CHECK(place(include));
    }
}

TEST_CASE("no folder has more than 30 sources") {
    for (const auto& counted : count_sources()) {
        CAPTURE(counted.first);
        CHECK(counted.second <= 30);
    }
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
