// From a scene's shapes and materials to the world's: the one conversion from double to float.
#pragma once

#include "tumble/scene.hpp"

namespace tumble::scene {

// The hull of the vertices, and what taking it did. Throws std::invalid_argument if no three of them span an area.
Shape make_hull(const PolygonGeometry& polygon, HullReport* report);

// The material of this name, or null.
const SceneMaterial* find_material(const Scene& scene, const std::string& name);

SurfaceMaterial make_surface(const SceneMaterial& material);

}  // namespace tumble::scene
