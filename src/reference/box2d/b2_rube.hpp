// An import of a R.U.B.E. export beside Box2D 2.4.1 built from the same file: what its bodies weigh, and where its
// joints hold them.
#pragma once

#include <filesystem>

#include "tumble/scene.hpp"

namespace tumble::reference {

// The largest differences. Mass and inertia (about the body's origin) are of dynamic bodies that are active, relative
// to Box2D's; the centre of mass is relative to the radius of gyration about the origin; anchors are in world
// coordinates at load, in m.
struct ImportDifferences {
    double mass = 0.0;
    double center = 0.0;
    double inertia = 0.0;
    double anchor = 0.0;
    int bodies = 0;  // compared
    int joints = 0;
    bool same_count = true;  // of bodies and of joints
};

// `imported` is what import_rube() makes of the file. Throws FileError; std::runtime_error for what is no export.
ImportDifferences compare_with_box2d(const std::filesystem::path& rube_file, const Scene& imported);

}  // namespace tumble::reference
