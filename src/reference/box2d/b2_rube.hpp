// Compares an imported R.U.B.E. export with a Box2D 2.4.1 world built from the same file: masses of bodies and anchors
// of joints.
#pragma once

#include <filesystem>
#include <string>

#include "tumble/scene.hpp"

namespace tumble::reference {

// The largest difference of one kind, and the body or joint that has it.
struct ImportDifference {
    double value = 0.0;
    std::string owner{};  // its output name; empty if the value is 0
};

// The largest differences. Mass and inertia (about the body's origin) are of dynamic bodies that are active, relative
// to Box2D's; the centre of mass is relative to the radius of gyration about the origin; anchors are in world
// coordinates at load, in m, less the rounding of Box2D's float coordinates farther than 100 m from the origin.
//
// Inertias are compared of bodies that may rotate. An inertia that is less than that of a mass point at the centre of
// mass, which Box2D refuses by an assertion, is not compared either.
struct ImportDifferences {
    ImportDifference mass;
    ImportDifference center;
    ImportDifference inertia;
    ImportDifference anchor;
    int bodies = 0;  // compared
    int joints = 0;
    int refused_inertias = 0;
    bool same_count = true;  // of bodies and of joints
};

// `imported` is the result of import_rube() for the file. Throws FileError, or std::runtime_error if the file is not
// an export.
ImportDifferences compare_with_box2d(const std::filesystem::path& rube_file, const Scene& imported);

}  // namespace tumble::reference
