// Small drawings and what their import gives.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <variant>

#include "tumble/scene.hpp"
#include "tumble/scene_import.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::test {

// A drawing of 1 m x 1 m with these elements.
inline ImportedScene import_text(const std::string& content, const SvgOptions& options = {}) {
    return parse_svg("<svg viewBox='0 0 100 100'>" + content + "</svg>", "test.svg", options);
}

template <class Geometry>
const Geometry& only_shape(const SceneBody& body) {
    REQUIRE(body.shapes.size() == 1);
    REQUIRE(std::holds_alternative<Geometry>(body.shapes.at(0).geometry));
    return std::get<Geometry>(body.shapes.at(0).geometry);
}

inline std::map<std::string, int> notes_of(const ImportedScene& imported) {
    std::map<std::string, int> notes;
    for (const ImportNote& note : imported.notes) notes[note.feature] = note.count;
    return notes;
}

inline double area_of(const SceneBody& body) {
    double area = 0.0;
    for (const SceneShape& shape : body.shapes)
        for (const Shape& part : make_shapes(shape.geometry)) area += mass_properties(part).area;
    return area;
}

// Within `tolerance` of each other, component by component.
inline bool near(DVec2 a, DVec2 b, double tolerance = 1e-12) {
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

}  // namespace tumble::test
