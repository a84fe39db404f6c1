// Definitions of bodies, shapes and joints as dictionaries. Members that a dictionary does not name keep their
// defaults; a name that the definition does not have throws py::type_error.
#pragma once

#include <string>

#include "python/bindings/convert.hpp"
#include "tumble/body.hpp"
#include "tumble/joint.hpp"
#include "tumble/query.hpp"
#include "tumble/world.hpp"

namespace tumble::python {

WorldDef to_world_def(const py::dict& members);
BodyDef to_body_def(const py::dict& members);
ShapeDef to_shape_def(const Shape& shape, const py::dict& members);
SurfaceMaterial to_material(const py::dict& members);
CollisionFilter to_filter(const py::dict& members);
QueryFilter to_query_filter(const py::dict& members);

// `kind` is the name of the kind in scene files: "revolute", "prismatic"... change_joint() changes what the dictionary
// names.
JointDef to_joint_def(const std::string& kind, const py::dict& members);
void change_joint(JointDef& joint, const py::dict& members);
std::string kind_of(const JointDef& joint);

py::dict to_dict(const WorldDef& def);
py::dict to_dict(const BodyDef& def);
py::dict to_dict(const SurfaceMaterial& material);
py::dict to_dict(const CollisionFilter& filter);
py::dict to_dict(const JointDef& def);

}  // namespace tumble::python
