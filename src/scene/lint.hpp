// Warnings for scenes that are valid but likely to disappoint, each with the reason and a remedy.
#pragma once

#include "scene/diagnostics.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// For a scene without errors. One warning for all copies of a body; builds a world and steps it once.
void add_lints(const Scene& scene, Diagnostics& diagnostics);

// What the bodies and joints show by themselves: slivers, sizes, speeds, masses that are tied together.
void add_body_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// What the first contacts show, in a world of this scene whose bodies all started awake and at rest and that has made one
// step: overlap, masses in contact, bodies asleep in the air, stacks.
void add_contact_lints(const Scene& scene, const SceneWorld& started, Diagnostics& diagnostics);

// Times the other one, whichever is heavier.
double mass_ratio(const World& world, BodyId a, BodyId b);

inline constexpr double kLargeMassRatio = 100.0;

}  // namespace tumble::scene
