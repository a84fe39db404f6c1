// From the shapes and materials of a scene to those of the world, rounded from double to float.
#pragma once

#include "tumble/scene.hpp"

namespace tumble::scene {

// The hull of the vertices; `report`, if given, counts those that it ignores. Throws std::invalid_argument if no three
// of them span an area.
Shape make_hull(const PolygonGeometry& polygon, HullReport* report);

// The material of this name, or null.
const SceneMaterial* find_material(const Scene& scene, const std::string& name);

SurfaceMaterial make_surface(const SceneMaterial& material);

}  // namespace tumble::scene
