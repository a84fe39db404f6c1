// Diagnostics of scenes as Python has them.
#pragma once

#include <vector>

#include "python/bindings/convert.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::python {

// A list of tumble.errors.Diagnostic.
py::list to_list(const std::vector<Diagnostic>& diagnostics);

}  // namespace tumble::python
