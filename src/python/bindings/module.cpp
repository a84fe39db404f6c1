#include "python/bindings/module.hpp"

PYBIND11_MODULE(_tumble, module) {
    using namespace tumble::python;
    module.doc() = "The C++ part of the package tumble. Its interface may change: use the package.";
    add_errors(module);
    add_shapes(module);
    add_distance(module);
    add_world(module);
    add_scene(module);
    add_render(module);
    add_env(module);
}
