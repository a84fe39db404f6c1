// From a body of a scene to definitions for the world: once for all copies, at load or when the run starts.
#pragma once

#include <vector>

#include "tumble/scene.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

// What all copies of a body share: everything but the pose.
struct BodyPlan {
    BodyDef def;
    std::vector<ShapeDef> shapes;
};

BodyDef make_body_def(const SceneBody& body);

// One definition, or several for chains and outlines. Throws std::invalid_argument for degenerate geometry, and leaves
// `defs` unchanged then.
void append_shape_defs(const Scene& scene, const SceneShape& shape, std::vector<ShapeDef>& defs);

// Both of the above, for all shapes.
BodyPlan plan_body(const Scene& scene, const SceneBody& body);

// Throws std::invalid_argument for what the world refuses.
BodyId create_body(World& world, const BodyPlan& plan, const Pose& pose);

}  // namespace tumble::scene
