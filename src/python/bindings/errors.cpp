// C++ exceptions as the classes of tumble/errors.py. std::invalid_argument becomes ValueError by pybind11.
#include "python/bindings/errors.hpp"

#include "python/bindings/ids.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/world_box.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/world.hpp"

namespace tumble::python {

namespace {

py::object class_of(const char* name) {
    static py::dict& classes = *new py::dict();  // never destroyed: Python may be gone by then
    if (!classes.contains(name)) classes[name] = py::module_::import("tumble.errors").attr(name);
    return classes[name];
}

template <class... Arguments>
void set_error(const char* name, Arguments&&... arguments) {
    const py::object type = class_of(name);
    PyErr_SetObject(type.ptr(), type(std::forward<Arguments>(arguments)...).ptr());
}

}  // namespace

py::list to_list(const std::vector<Diagnostic>& diagnostics) {
    const py::object type = class_of("Diagnostic");
    py::list list;
    for (const Diagnostic& d : diagnostics)
        list.append(type(d.severity == Diagnostic::Severity::error ? "error" : "warning", d.file, d.line, d.column,
                         d.pointer, d.message, d.hint, d.code, to_string(d)));
    return list;
}

void add_errors(py::module_&) {
    // pybind11 passes it by value. NOLINTNEXTLINE(performance-unnecessary-value-param)
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const SceneError& error) {
            set_error("SceneError", error.what(), to_list(error.diagnostics));
        } catch (const SnapshotError& error) {
            set_error("SnapshotError", error.what());
        } catch (const SimulationDiverged& error) {
            set_error("SimulationDiverged", error.what(), to_number(error.body), error.step);
        } catch (const RenderError& error) {
            set_error("RenderError", error.what());
        } catch (const InUse& error) {
            set_error("InUseError", error.what());
        } catch (const FileError& error) {
            set_error("FileError", error.what());
        }
    });
}

}  // namespace tumble::python
