// Reads the #include lines of the whole project and fails on an upward include, or on a third-party header outside
// its room. The tables below are the design's, and the README's page on the rooms shows the same.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
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

// Rooms whose private headers (src/<room>/...) a room may include besides its own.
const std::map<std::string, std::set<std::string>> kMaySee = {
    {"file", {}},
    {"math", {}},
    {"simd", {"math"}},
    {"shape", {"math"}},
    {"narrow", {"math", "simd", "shape"}},
    {"broad", {"math"}},
    {"dynamics", {"math", "simd", "shape", "narrow", "broad"}},
    {"world", {"math", "simd", "shape", "narrow", "broad", "dynamics"}},
    {"scene", {}},
    {"render", {}},
    {"reference", {}},
};

// Public headers that a lower room may include; rooms not named here may include all of them.
const std::map<std::string, std::set<std::string>> kPublicHeaders = {
    {"file", {"file.hpp"}},
    {"math", {"math.hpp"}},
    {"simd", {"math.hpp"}},
    {"shape", {"math.hpp", "shape.hpp", "outline.hpp"}},
    {"narrow", {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp"}},
    {"broad", {"math.hpp"}},
    {"dynamics",
     {"math.hpp", "shape.hpp", "distance.hpp", "cast.hpp", "compound.hpp", "manifold.hpp", "chain.hpp", "id.hpp",
      "body.hpp", "joint.hpp", "events.hpp", "counters.hpp"}},
};

// Third-party headers by their first folder or whole name, and the rooms that may include them.
const std::map<std::string, std::set<std::string>> kThirdParty = {
    {"Eigen", {"simd", "dynamics", "reference", "include"}},
    {"GL", {"render"}},
    {"stb_image_write.h", {"render"}},
    {"stb_truetype.h", {"render"}},
    {"libdeflate.h", {"render"}},
    {"nlohmann", {"scene", "tools", "reference"}},
    {"rapidjson", {"tools"}},
    {"libfccp", {"tools"}},
    {"CLI", {"tools"}},
    {"xxhash.h", {"world", "scene"}},
    {"box2d", {"reference"}},
    {"gmp.h", {"reference"}},
    {"gmpxx.h", {"reference"}},
    {"pugixml.hpp", {"scene"}},
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

}  // namespace

TEST_CASE("rooms include only rooms below them") {
    int checked = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "src")) {
        if (!entry.is_directory()) continue;
        const std::string room = entry.path().filename().string();
        REQUIRE_MESSAGE(kMaySee.contains(room), "the room " << room << " is not in the table");
        for (const Include& include : includes_below(entry.path())) {
            ++checked;
            check_third_party(include, room);
            const std::string target_room = first_folder(include.target);
            if (target_room == "tumble") {
                const auto allowed = kPublicHeaders.find(room);
                if (allowed != kPublicHeaders.end() && !allowed->second.contains(include.target.substr(7)))
                    FAIL_CHECK(place(include));
            } else if (include.quoted && target_room != room && !kMaySee.at(room).contains(target_room)) {
                FAIL_CHECK(place(include));
            }
        }
    }
    CHECK(checked > 0);
}

TEST_CASE("public headers include the standard library and each other only") {
    for (const Include& include : includes_below(root / "include")) {
        check_third_party(include, "include");
        if (include.quoted && first_folder(include.target) != "tumble") FAIL_CHECK(place(include));
    }
}

TEST_CASE("tools see public headers, the reference room and their own files only") {
    for (const Include& include : includes_below(root / "tools")) {
        check_third_party(include, "tools");
        if (!include.quoted) continue;
        const bool own = include.target.find('/') == std::string::npos;
        const std::string folder = first_folder(include.target);
        if (!own && folder != "tumble" && folder != "reference") FAIL_CHECK(place(include));
    }
}
