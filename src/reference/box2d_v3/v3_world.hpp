// A scene as a world of Box2D v3: the same bodies, shapes, masses, materials and joints.
#pragma once

#include <memory>

#include "tumble/math.hpp"
#include "tumble/scene.hpp"

namespace tumble::reference {

class V3World {
public:
    // Whether it can hold the scene: events are not carried over, nor are joints that v3_joint_plan() lacks. Throws the
    // exceptions of build_world().
    static bool can_hold(const Scene& scene);

    // Takes shapes, masses and joints from tumble's world of the scene. A polygon of more than eight vertices becomes a
    // fan. Only in a build with has_box2d_v3(). Throws the exceptions of build_world().
    explicit V3World(const Scene& scene);
    ~V3World();
    V3World(V3World&&) noexcept;
    V3World& operator=(V3World&&) noexcept;

    // One step of the scene's duration, with the sub-steps of the scene.
    void step();

    Pose pose(int body) const;  // in the order of SceneWorld::bodies

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble::reference
