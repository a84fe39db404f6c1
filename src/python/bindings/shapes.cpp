// Shapes: the factories, and what a shape is.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdio>

#include "python/bindings/convert.hpp"
#include "python/bindings/module.hpp"
#include "tumble/shape.hpp"

namespace tumble::python {

namespace {

py::array_t<float> vertices_of(const Shape& shape) {
    py::array_t<float> vertices({py::ssize_t{shape.vertex_count()}, py::ssize_t{2}});
    auto out = vertices.mutable_unchecked<2>();
    for (int i = 0; i < shape.vertex_count(); ++i) {
        out(i, 0) = shape.vertex(i).x;
        out(i, 1) = shape.vertex(i).y;
    }
    return vertices;
}

// "<Shape of 4 vertices, radius 0.1 m, 2 x 1 m>"
std::string text_of(const Shape& shape) {
    const Aabb box = bounds(shape, Pose{});
    char text[120];
    std::snprintf(text, sizeof text, "<Shape of %d %s, radius %g m, %.6g x %.6g m>", shape.vertex_count(),
                  shape.vertex_count() == 1 ? "vertex" : "vertices", double{shape.radius()}, box.upper.x - box.lower.x,
                  box.upper.y - box.lower.y);
    return text;
}

std::vector<Vec2> points_of(const Doubles& points) {
    const auto in = points.unchecked<2>();
    std::vector<Vec2> result;
    for (py::ssize_t i = 0; i < in.shape(0); ++i) result.push_back(to_float({in(i, 0), in(i, 1)}));
    return result;
}

}  // namespace

void add_shapes(py::module_& module) {
    py::class_<Shape>(
        module, "Shape",
        "A convex outline of one or more points, grown by a radius; it cannot be changed.\n\n"
        "circle(), capsule(), segment(), box() and polygon() make one. Lengths are in m, in coordinates of "
        "the body.")
        .def_property_readonly("vertices", vertices_of,
                               "[n, 2], m, counter-clockwise: a copy. One for a circle, two for a capsule.")
        .def_property_readonly("radius", &Shape::radius, "By which the outline of the vertices is grown, m.")
        .def_property_readonly("vertex_count", &Shape::vertex_count, "1 to 65535.")
        .def_property_readonly(
            "area", [](const Shape& shape) { return mass_properties(shape).area; }, "m^2.")
        .def_property_readonly(
            "centroid", [](const Shape& shape) { return to_tuple(DVec2(mass_properties(shape).center)); }, "m.")
        .def_property_readonly(
            "second_moment", [](const Shape& shape) { return mass_properties(shape).inertia; },
            "Of the area, about the centroid, m^4: times the density it is the inertia.")
        .def("__repr__", text_of)
        .def("__eq__",
             [](const Shape& a, const py::object& b) { return py::isinstance<Shape>(b) && a == b.cast<Shape>(); })
        .def("__hash__",
             [](const Shape& a) {
                 const py::object vertices = vertices_of(a) + py::float_(0.0);  // -0.0 becomes 0.0, which equals it
                 return py::hash(py::bytes(vertices.attr("tobytes")()));
             })
        .def(py::pickle([](const Shape& shape) { return py::make_tuple(Doubles(vertices_of(shape)), shape.radius()); },
                        [](const py::tuple& state) {
                            return Shape::from_raw(points_of(state[0].cast<Doubles>()), state[1].cast<float>());
                        }));
    module.def("circle", [](float radius, Pair center) { return make_circle(radius, to_vec2(center)); });
    module.def("capsule",
               [](Pair from, Pair to, float radius) { return make_capsule(to_vec2(from), to_vec2(to), radius); });
    module.def("segment", [](Pair from, Pair to) { return make_segment(to_vec2(from), to_vec2(to)); });
    module.def("box", [](Pair size, float radius, Pair center, double angle) {
        return make_box(to_vec2(size), radius, to_vec2(center), angle);
    });
    module.def("polygon", [](const Doubles& points, float radius, bool exact) {
        const std::vector<Vec2> corners = points_of(points);
        return exact ? make_exact_polygon(corners, radius) : make_polygon(corners, radius);
    });
}

}  // namespace tumble::python
