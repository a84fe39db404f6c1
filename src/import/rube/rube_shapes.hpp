// Fixtures of R.U.B.E. exports as shapes of a scene.
#pragma once

#include <optional>

#include "import/rube/rube_values.hpp"

namespace tumble::scene {

// Friction, restitution and density of a fixture, to be shared by all that have the same.
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

// Nothing, with a note, for what has no extent.
std::optional<RubeFixture> read_rube_fixture(RubeObject fixture, RubeNotes& notes);

}  // namespace tumble::scene
