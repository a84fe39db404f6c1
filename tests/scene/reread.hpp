// A scene after it was written and read again.
#pragma once

#include "tumble/scene_file.hpp"

namespace tumble::test {

inline Scene reread(const Scene& scene) { return parse_scene(to_json(scene), "written.json"); }

}  // namespace tumble::test
