// Values between Python and C++: pairs of numbers as vectors, dictionaries as definitions.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <utility>

#include "tumble/math.hpp"

namespace tumble::python {

namespace py = pybind11;

using Pair = std::pair<double, double>;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline DVec2 to_dvec2(Pair pair) { return {pair.first, pair.second}; }
inline Vec2 to_vec2(Pair pair) { return to_float(to_dvec2(pair)); }
inline py::tuple to_tuple(DVec2 v) { return py::make_tuple(v.x, v.y); }
inline py::tuple to_tuple(Vec2 v) { return py::make_tuple(v.x, v.y); }

// A pose as x, y and the angle in rad, or as x, y, cosine and sine.
inline Pose to_pose(DVec2 position, double angle) { return {position, make_rotation(angle)}; }

}  // namespace tumble::python
