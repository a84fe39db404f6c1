// From a scene's body to one of a world: at load, for each copy, and when it is spawned.
#pragma once

#include <vector>

#include "tumble/scene.hpp"
#include "tumble/world.hpp"

namespace tumble::scene {

// What all copies of a body share.
struct BodyPlan {
    BodyDef def;
    std::vector<ShapeDef> shapes;
};

// Throws std::invalid_argument for degenerate geometry.
BodyPlan plan_body(const Scene& scene, const SceneBody& body);

// Throws std::invalid_argument for what the world refuses.
BodyId create_body(World& world, const BodyPlan& plan, const Pose& pose);

}  // namespace tumble::scene
