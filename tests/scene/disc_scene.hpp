// The scene of most tests of runs.
#pragma once

#include <string>

#include "tumble/scene.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::test {

// A disc of mass pi / 4 kg (radius 0.5 m, density 1) without gravity for 2 s, and further members of the scene.
inline Scene make_disc_scene(const std::string& more) {
    return parse_scene(R"({"format": 1, "world": {"gravity": [0, 0], "duration": 2},
        "bodies": [{"name": "disc", "shapes": [{"circle": {"radius": 0.5}}]}], )" +
                           more + "}",
                       "");
}

}  // namespace tumble::test
