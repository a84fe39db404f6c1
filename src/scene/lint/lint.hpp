// Warnings for scenes that are valid but unlikely to behave as their author expects, each with the reason and a remedy.
// All copies of a body or joint get one warning.
#pragma once

#include "scene/build/resolved_scene.hpp"
#include "scene/json/diagnostics.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// For a scene without errors. Builds a world and steps it once.
void add_lints(const Scene& scene, const ResolvedScene& resolved, Diagnostics& diagnostics);

// Warns of an angle (degrees) that seems to be in radians.
void lint_degrees(double degrees, const std::string& pointer, Diagnostics& diagnostics);

// Single bodies: slivers, sizes outside the tested range, dynamic bodies without mass, velocities and masses without
// effect, angles in radians, images without their files.
void add_body_lints(const Scene& scene, Diagnostics& diagnostics);

// Bodies that may pass through others, because their surface moves farther in a step than they are thick, by their
// velocity, a motor or an event, and because nothing sweeps them against these others.
void add_motion_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// Joints before the first step: large mass ratios, anchors apart or far away, angles out of their range or in
// radians, springs too stiff for the steps.
void add_joint_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// One-sided chains with a body on their solid side, which falls through.
void add_chain_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics);

// Events and claims after the end of the run, and events without effect.
void add_run_lints(const Scene& scene, Diagnostics& diagnostics);

// The first contacts, in a world of this scene whose bodies started awake and at rest, after one step: overlaps, large
// mass ratios, bodies that sleep without support, stacks that sink, rows over which an impact spreads.
void add_contact_lints(const Scene& scene, const SceneWorld& started, Diagnostics& diagnostics);

}  // namespace tumble::scene
