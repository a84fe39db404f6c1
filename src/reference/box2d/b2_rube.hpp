// Compares an imported R.U.B.E. export with a Box2D 2.4.1 world built from the same file: masses of bodies and anchors
// of joints.
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

// `imported` is the result of import_rube() for the file. Throws FileError, or std::runtime_error if the file is not
// an export.
ImportDifferences compare_with_box2d(const std::filesystem::path& rube_file, const Scene& imported);

}  // namespace tumble::reference
