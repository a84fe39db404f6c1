// Scenes with their worlds, built by hand instead of from files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// The scene geometry of a shape.
inline ShapeGeometry geometry_of(const Shape& shape) {
    const double radius = double{shape.radius()};
    std::vector<DVec2> vertices;
    for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(DVec2(shape.vertex(i)));
    if (vertices.size() == 1) return CircleGeometry{radius, vertices[0]};
    if (vertices.size() == 2 && radius > 0.0) return CapsuleGeometry{vertices[0], vertices[1], radius};
    if (vertices.size() == 2) return SegmentGeometry{vertices[0], vertices[1]};
    return PolygonGeometry{vertices, radius};
}

struct HandMadeScene {
    Scene scene;
    SceneWorld built;

    BodyId add(std::string name, BodyType type, DVec2 position, const std::vector<Shape>& shapes,
               double degrees = 0.0) {
        SceneBody body;
        body.name = name;
        body.type = type;
        body.position = position;
        body.angle = degrees;
        for (const Shape& shape : shapes) body.shapes.push_back({geometry_of(shape), "", ""});
        scene.bodies.push_back(body);
        BodyDef def;
        def.type = type;
        def.pose = {position, make_rotation_degrees(degrees)};
        const BodyId id = built.world.create_body(def);
        for (const Shape& shape : shapes) built.world.add_shape(id, {shape, {}});
        built.bodies.push_back({id, scene.bodies.size() - 1, std::move(name)});
        return id;
    }

    BodyId add_static(std::string name, DVec2 position, const Shape& shape) {
        return add(std::move(name), BodyType::static_body, position, {shape});
    }

    BodyId add_dynamic(std::string name, DVec2 position, const Shape& shape, double degrees = 0.0) {
        return add(std::move(name), BodyType::dynamic_body, position, {shape}, degrees);
    }
};

}  // namespace tumble
