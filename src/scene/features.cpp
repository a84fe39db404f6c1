// What a scene may say and this version does not simulate yet. A feature leaves this list when its room is built.
#include <algorithm>

#include "tumble/scene.hpp"

namespace tumble {

namespace {

struct Ignored {
    std::vector<std::string> lines;

    void add(const std::string& feature, std::ptrdiff_t count) {
        if (count > 0) lines.push_back(feature + " (" + std::to_string(count) + ")");
    }
};

bool has_spawn(const SceneEvent& event) { return event.spawn.has_value(); }

}  // namespace

std::vector<std::string> ignored_features(const Scene& scene) {
    Ignored ignored;
    ignored.add("timeline: spawned bodies do not appear", std::ranges::count_if(scene.timeline, &has_spawn));
    return ignored.lines;
}

}  // namespace tumble
