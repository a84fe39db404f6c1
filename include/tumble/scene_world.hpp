// Building the world that a scene describes. Each number of the scene is converted once, so that a scene that is saved
// and loaded again gives the same world bit for bit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tumble/joint.hpp"
#include "tumble/scene.hpp"
#include "tumble/shape.hpp"
#include "tumble/world.hpp"

namespace tumble {

// The shapes of a scene's shape, in body coordinates: one, or several for chains and outlines. Throws
// std::invalid_argument, with the value printed, for degenerate geometry.
std::vector<Shape> make_shapes(const ShapeGeometry& geometry);

// The same for a distance query: a polygon is the exact hull of its vertices (make_exact_polygon()), a point or a
// segment if they span no area.
std::vector<Shape> make_exact_shapes(const ShapeGeometry& geometry);

// The number of bodies in the world of a scene, copies included.
std::size_t count_bodies(const Scene& scene);

// The number of joints, copies included.
std::size_t count_joints(const Scene& scene);

// One body of the built world. `source` is the index of its entry in Scene::bodies or, from bodies.size() on, in
// Scene::timeline; `name` is its name after repeating (empty for unnamed bodies).
struct SceneInstance {
    BodyId id;
    std::size_t source = 0;
    std::string name;
};

// The entry that the body came from.
const SceneBody& source_of(const Scene& scene, const SceneInstance& body);

// One joint of the built world. `source` is the index of its entry in Scene::joints, `name` its name after repeating
// (empty for unnamed joints).
struct SceneJointInstance {
    JointId id;
    std::size_t source = 0;
    std::string name;
};

struct SceneWorld {
    World world;
    std::vector<SceneInstance> bodies;       // in the order of creation; the ids of destroyed ones are stale
    std::vector<SceneJointInstance> joints;  // in the order of the scene and of the copies, gears last
    double work = 0.0;  // J: the kinetic and potential energy that events of the timeline and motors have added so far
};

// The name of a body or joint in output: its own, or body[i] or joint[i] by its index in SceneWorld.
std::string output_name(const SceneInstance& body, std::size_t index);
std::string output_name(const SceneJointInstance& joint, std::size_t index);

// Throws SceneError if the scene is not valid, which load_scene() excludes, if it was loaded with keep_includes, or if
// the world refuses a body or joint.
SceneWorld build_world(const Scene& scene);

}  // namespace tumble
