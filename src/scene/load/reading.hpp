// Reads a scene file and the files that it includes: JSON, overrides, fields, includes, validation. Each stage
// continues as far as the errors of the one before allow, so that a user sees all errors at once.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/build/resolved_scene.hpp"
#include "scene/format/draw.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/included_parts.hpp"
#include "scene/json/json.hpp"
#include "scene/model/scene_sizes.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::scene {

inline constexpr std::size_t kMaxIncludeDepth = 16;      // files that include each other
inline constexpr std::size_t kMaxIncludedFiles = 10000;  // read in all
inline constexpr std::size_t kMaxIncludedEntries =
    1000000;  // copied in one reading: a bound for files that include others many times

struct ReadScene {
    Scene scene;                              // its own entries, then those of the files that it includes
    SceneSizes own{};                         // how many entries are its own
    std::optional<ResolvedScene> resolved{};  // there and complete if there are no errors
};

// Reads one scene. A file that is included many times is read and validated once.
class Reading {
public:
    explicit Reading(const LoadOptions& options)
        : read_(options.read_included), allow_outside_(options.allow_outside) {}

    // The scene with everything that it includes. Errors go to `diagnostics`. `parsed` is the value of the text, if it
    // is known.
    ReadScene read(std::string_view text, const std::filesystem::path& file, const LoadOptions& changes,
                   Diagnostics& diagnostics, const Json* parsed = nullptr);

private:
    void include_all(Scene& scene, const std::filesystem::path& file, Diagnostics& diagnostics);
    const Scene* find_part(const std::filesystem::path& file, const std::string& include, Diagnostics& diagnostics);
    std::optional<Scene> read_part(const std::filesystem::path& file, const std::string& include,
                                   Diagnostics& diagnostics);
    std::string chain_to(const std::filesystem::path& file) const;

    ReadIncluded read_;
    bool allow_outside_;
    std::map<std::filesystem::path, std::optional<Scene>> parts_;  // nothing for a file with errors
    std::vector<std::filesystem::path> open_;                      // from the scene down to the file that is being read
    std::size_t files_read_ = 0;
    DrawContext context_;      // of the file that is being read
    std::size_t entries_ = 0;  // copied so far
};

}  // namespace tumble::scene
