// The parts of the extension module. Each function adds one subject to it.
#pragma once

#include <pybind11/pybind11.h>

namespace tumble::python {

namespace py = pybind11;

void add_errors(py::module_& module);    // first: the classes of exceptions
void add_shapes(py::module_& module);    // shapes and their mass
void add_distance(py::module_& module);  // distances of shapes, alone and by the million
void add_world(py::module_& module);     // class World: stepping, bodies, shapes, joints, snapshots
void add_scene(py::module_& module);     // scene texts, runs, claims
void add_render(py::module_& module);    // frames
void add_env(py::module_& module);       // many worlds in one call

}  // namespace tumble::python
