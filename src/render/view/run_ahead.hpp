// Where the bodies of a scene will go, found by running it: what a camera should have in view is not known before.
#pragma once

#include <vector>

#include "render/view/box.hpp"
#include "tumble/scene.hpp"

namespace tumble::render {

// The boxes that a body covers where it begins, and in all of the run that was looked at.
struct BodyWay {
    Box first;
    Box all;
};

// The ways of all bodies that are not static, those that the timeline makes included. Runs to the scene's end, or for
// as many steps as its bodies leave of a fixed number of steps of one body: the same for every frame and machine. What
// cannot be run further is looked at until then; a scene of thousands of bodies is not run, and has no ways.
std::vector<BodyWay> run_ahead(const Scene& scene);

}  // namespace tumble::render
