// A scene as a world of Box2D 2.4.1, for comparison: equal masses, materials and joints, and the nearest shapes that
// Box2D has.
//
// A capsule becomes a box and two circles, a rounded polygon a polygon with m_radius, a polygon of more than 8 vertices
// a fan of such polygons, a segment a two-sided edge. Polygons keep their vertices: they do not pass through Set(),
// which welds them; those without a radius keep Box2D's usual skin of 1 cm. Features that Box2D lacks (rolling
// resistance, tangent speed) are left out, and notes() lists them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tumble/math.hpp"
#include "tumble/scene.hpp"

namespace tumble::reference {

class B2World {
public:
    // Takes shapes, masses and joints from tumble's world of the scene. Throws the exceptions of build_world().
    explicit B2World(const Scene& scene);
    ~B2World();
    B2World(B2World&&) noexcept;
    B2World& operator=(B2World&&) noexcept;

    // One step of the scene's duration with the iteration counts that Box2D recommends.
    void step(int velocity_iterations = 8, int position_iterations = 3);

    // Bodies in the order of SceneWorld::bodies.
    int body_count() const;
    Pose pose(int body) const;
    Vec2 velocity(int body) const;           // of the centre of mass, m/s
    float angular_velocity(int body) const;  // rad/s
    bool is_awake(int body) const;

    int contact_count() const;      // touching pairs of fixtures
    float deepest_overlap() const;  // m, at least 0: the most negative separation of a contact point, skins included

    // What was left out or could not be built, one line each; empty if the scene maps completely.
    const std::vector<std::string>& notes() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble::reference
