// Reads fixtures of R.U.B.E. exports.
#pragma once

#include <optional>

#include "import/rube/rube_values.hpp"

namespace tumble::scene {

// The surface of a fixture. Fixtures with equal surfaces share a material.
struct RubeSurface {
    double density = 0.0;
    double friction = 0.0;
    double restitution = 0.0;

    friend bool operator==(const RubeSurface&, const RubeSurface&) = default;
};

struct RubeFixture {
    ShapeGeometry geometry;
    RubeSurface surface;
    std::string custom;  // name and custom properties
    std::optional<SceneFilter> filter;
    bool sensor = false;
};

// Empty, with a note, for a fixture without a shape or with a degenerate one. Notes name the body by `owner`.
std::optional<RubeFixture> read_rube_fixture(RubeObject fixture, const std::string& owner, RubeNotes& notes);

}  // namespace tumble::scene
