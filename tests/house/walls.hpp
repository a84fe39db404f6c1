// The walls between the folders: which folder may include which, and which rooms lie below which. The tests of includes
// and of calls read the same tables.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tumble::test {

inline const std::filesystem::path kProject = TUMBLE_SOURCE_DIR;

// What each folder may include besides its own files, debug and public headers. A name stands for a folder and all
// below it.
inline const std::map<std::string, std::set<std::string>> kMaySee = {
    {"debug", {}},
    {"file", {}},
    {"math", {}},
    {"simd", {"math"}},
    {"simd/dispatch", {}},
    {"shape", {"math"}},
    {"tasks", {}},
    {"broad", {"math", "tasks"}},
    {"narrow/cores", {"math", "simd", "shape"}},
    {"narrow/gjk", {"narrow/cores"}},
    {"narrow/faces", {"simd", "narrow/cores", "narrow/gjk"}},
    {"narrow/distance", {"simd", "narrow/cores", "narrow/gjk", "narrow/faces"}},
    {"narrow/manifold", {"shape", "narrow/cores", "narrow/distance"}},
    {"narrow/cast", {"simd", "narrow/cores"}},
    {"narrow/impact", {"math", "narrow/cores", "narrow/distance", "narrow/cast"}},
    {"narrow/compound", {"narrow/cores", "narrow/distance", "narrow/cast", "narrow/impact"}},
    {"dynamics/bodies", {"math", "simd", "tasks", "broad"}},
    {"dynamics/contacts", {"simd", "tasks", "broad", "narrow/manifold", "dynamics/bodies"}},
    {"dynamics/rows", {"dynamics/bodies"}},
    {"dynamics/joints", {"dynamics/bodies", "dynamics/rows"}},
    {"dynamics/joint_store", {"simd", "tasks", "dynamics/bodies", "dynamics/rows", "dynamics/joints"}},
    {"dynamics/direct", {"dynamics/bodies", "dynamics/rows", "dynamics/joint_store"}},
    {"dynamics/impacts", {}},
    {"dynamics/state",
     {"tasks", "broad", "dynamics/bodies", "dynamics/contacts", "dynamics/rows", "dynamics/joint_store",
      "dynamics/direct", "dynamics/impacts"}},
    {"dynamics/stages", {"dynamics/bodies", "dynamics/contacts", "dynamics/state"}},
    {"dynamics/continuous",
     {"dynamics/bodies", "dynamics/contacts", "dynamics/impacts", "dynamics/state", "dynamics/stages"}},
    {"dynamics",
     {"dynamics/bodies", "dynamics/contacts", "dynamics/direct", "dynamics/state", "dynamics/stages",
      "dynamics/continuous"}},
    {"world", {"tasks", "dynamics"}},
    {"scene/json", {}},
    {"scene/format", {"scene/json"}},
    {"scene/model", {"scene/json", "scene/format"}},
    {"scene/expressions", {"scene/format", "scene/model"}},
    {"scene/claims", {"scene/json", "scene/format", "scene/model", "scene/expressions"}},
    {"scene/build", {"scene/json", "scene/format", "scene/model", "scene/expressions", "scene/claims"}},
    {"scene/lint", {"scene/json", "scene/model", "scene/build", "scene/run"}},
    {"scene/load",
     {"scene/json", "scene/format", "scene/model", "scene/expressions", "scene/claims", "scene/build", "scene/lint"}},
    {"scene/run", {"scene/json", "scene/format", "scene/model", "scene/expressions", "scene/build"}},
    {"scene/health", {"scene/model", "scene/expressions", "scene/lint"}},
    {"import/rube", {"scene/json", "scene/format", "scene/model"}},
    {"import/svg", {"scene/json", "scene/format", "scene/model"}},
    {"render/style", {}},
    {"render/view", {}},
    {"render/canvas", {"render/style"}},
    {"render/shapes", {"render/style", "render/view", "render/canvas"}},
    {"render/frame", {"render/style", "render/view", "render/canvas", "render/shapes", "render/pictures"}},
    {"render/labels", {"render/style", "render/view", "render/canvas", "render/shapes"}},
    {"render/drawing", {"render/view", "render/canvas", "render/shapes"}},
    {"render/output", {}},
    {"render/pictures", {}},
    {"render/replay", {"render/style", "render/output"}},
    {"render/video", {}},
    {"python/bindings", {}},
    {"reference/query", {}},
    {"reference/exact", {"reference/query"}},
    {"reference/box2d", {"reference/query"}},
    {"reference/box2d_v3", {"reference/query", "reference/box2d", "reference/box2d_v3/library"}},
    {"reference/box2d_v3/library", {}},
    {"reference/bench", {"reference/query", "reference/box2d", "reference/box2d_v3", "reference/box2d_v3/library"}},
    {"reference/families", {"reference/query", "reference/exact", "reference/box2d"}},
    {"reference/parity",
     {"reference/query", "reference/exact", "reference/box2d", "reference/box2d_v3", "reference/families"}},
    {"reference/physics", {"reference/box2d"}},
    {"sweep/plan", {"scene/json", "scene/format", "scene/expressions"}},
    {"sweep/store", {}},
    {"sweep/hdf5", {"sweep/store"}},
    {"tools/output", {}},
    {"tools/cli", {"tools/output"}},
    {"tools/query", {"tools/output", "tools/cli"}},
    {"tools/machine", {"tools/output", "reference"}},
    {"tools/measure", {}},
    {"tools/bench", {"tools/output", "tools/machine", "tools/measure", "reference"}},
    {"tools/parity", {"tools/output", "tools/machine", "reference"}},
    {"tools/physics", {"tools/output", "tools/machine", "reference"}},
    {"tools/doctor", {"tools/output", "tools/machine"}},
    {"tools/diff", {"tools/output"}},
    {"tools/compare", {"tools/output", "tools/machine", "tools/diff", "tools/run", "tools/cli", "reference"}},
    {"tools/claims", {}},
    {"tools/plot", {"tools/output", "tools/cli"}},
    {"tools/tables", {"tools/output", "tools/cli"}},
    {"tools/labels", {"tools/output", "tools/cli", "tools/machine"}},
    {"tools/health", {"tools/output"}},
    {"tools/pictures", {"tools/output"}},
    {"tools/run",
     {"tools/output", "tools/claims", "tools/cli", "tools/machine", "tools/measure", "tools/tables", "tools/labels",
      "tools/health", "tools/pictures", "tools/plot"}},
    {"tools/scene", {"tools/output", "tools/cli", "tools/diff", "tools/measure", "tools/run"}},
    {"tools/gallery", {"tools/output", "tools/cli", "tools/run", "tools/scene"}},
    {"tools/sweep/runs", {"tools/output", "tools/cli", "tools/measure", "tools/tables", "sweep"}},
    {"tools/sweep", {"tools/output", "tools/cli", "tools/machine", "tools/measure", "tools/sweep/runs", "sweep"}},
    {"tools/shrink", {"tools/output", "tools/claims", "tools/cli", "tools/measure", "tools/scene"}},
    {"tools/commands",
     {"sweep",         "tools/shrink",  "tools/sweep", "tools/output", "tools/claims",  "tools/cli",   "tools/query",
      "tools/machine", "tools/measure", "tools/bench", "tools/parity", "tools/physics", "tools/diff",  "tools/doctor",
      "tools/compare", "tools/gallery", "tools/plot",  "tools/tables", "tools/run",     "tools/scene", "reference"}},
    {"tools/pages", {"tools/machine", "tools/commands"}},
    {"tools", {"tools/cli", "tools/commands"}},
};

// The rooms next below each room: whose functions it may call by a public header. Rooms below those are included.
inline const std::map<std::string, std::set<std::string>> kNextBelow = {
    {"debug", {}},
    {"file", {}},
    {"math", {}},
    {"simd", {"math"}},
    {"shape", {"math"}},
    {"tasks", {}},
    {"broad", {"math", "tasks"}},
    {"narrow", {"shape", "simd"}},
    {"dynamics", {"narrow", "broad"}},
    {"world", {"dynamics"}},
    {"scene", {"world", "file"}},
    {"import", {"scene"}},
    {"render", {"scene"}},
    {"reference", {"import"}},
    {"sweep", {"scene"}},
    {"python", {"import", "render"}},
    {"tools", {"import", "render", "reference", "sweep"}},
};

// The first folder of a path: "scene" of "scene/json/text.hpp".
inline std::string first_folder(const std::string& path) { return path.substr(0, path.find('/')); }

// The folder of a source as the tables name it: below src without that name, tools with it.
inline std::string folder_of_source(const std::filesystem::path& file) {
    const std::string folder = std::filesystem::relative(file.parent_path(), kProject).generic_string();
    return folder.starts_with("src/") ? folder.substr(4) : folder;
}

inline bool is_in(const std::string& folder, const std::string& above) {
    return folder == above || folder.starts_with(above + "/");
}

inline bool may_include(const std::string& folder, const std::string& target) {
    if (folder == target || target == "debug") return true;
    for (const std::string& seen : kMaySee.at(folder))
        if (is_in(target, seen)) return true;
    return false;
}

inline bool is_below(const std::string& room, const std::string& upper) {
    for (const std::string& next : kNextBelow.at(upper))
        if (next == room || is_below(room, next)) return true;
    return false;
}

}  // namespace tumble::test
