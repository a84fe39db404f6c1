// Thin lines and small dots for the joints, over the bodies.
#pragma once

#include <span>

#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"
#include "tumble/world.hpp"

namespace tumble::render {

// Appends the joints that are not destroyed: a dot at each anchor, and a line between the anchors if they are apart. A
// spring is a coil, which has the same number of turns at any length. A distance joint that only limits the length is
// a rope, which sags under gravity while it is slack. The line of a pulley runs over wheels.
void add_joints(Layer& layer, const View& view, const World& world, std::span<const JointId> joints,
                const Colors& colors);

}  // namespace tumble::render
