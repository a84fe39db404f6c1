// Warnings for scenes that are valid but likely to disappoint, each with the reason and a remedy. One warning for all
// copies.
#pragma once

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// For a scene without errors. Builds a world and steps it once.
void add_lints(const Scene& scene, const ResolvedScene& resolved, Diagnostics& diagnostics);

// What the bodies show by themselves: slivers, sizes, what weighs nothing, what cannot move.
void add_body_lints(const Scene& scene, Diagnostics& diagnostics);

// Whose surface moves farther in a step than it is thick: by its velocity, a motor or an event.
void add_motion_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// Joints before the first step: masses that are tied together, anchors apart or far away, springs too stiff for the
// steps.
void add_joint_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// Chains that bodies start behind, and fall through.
void add_chain_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// Events and claims that never come, and events that nothing obeys.
void add_run_lints(const Scene& scene, Diagnostics& diagnostics);

// What the first contacts show, in a world of this scene whose bodies all started awake and at rest and that has made
// one step: overlap, masses in contact, bodies asleep in the air, stacks.
void add_contact_lints(const Scene& scene, const SceneWorld& started, Diagnostics& diagnostics);

}  // namespace tumble::scene
