// Contacts, events and hits of rays as structured arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <vector>

#include "tumble/world.hpp"

namespace tumble::python {

namespace py = pybind11;

// Registers the types of entries with numpy. To be called once, before the functions below.
void register_reports();

py::array to_array(const std::vector<ContactPoint>& contacts);
py::dict to_dict(const StepEvents& events);

// The first hits of many rays, [n, 2] each: `hit` is false, and the ids are 0, where there is none.
py::array cast_rays(const World& world, const double* origins, const double* translations, py::ssize_t count,
                    const QueryFilter& filter);

}  // namespace tumble::python
