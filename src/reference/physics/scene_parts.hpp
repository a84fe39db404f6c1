// Parts of the scenes that the rows measure. All surfaces of a scene have its one material.
#pragma once

#include <string>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::reference {

struct SceneRate {
    double steps_per_second = 60.0;
    int substeps = 4;
};

// A scene without bodies that never sleeps. The material is that of all parts below.
Scene empty_scene(DVec2 gravity, double friction, double restitution, SceneRate rate = {});

// Bodies whose shape is centred on their origin. Angles are in degrees.
SceneBody disc(DVec2 position, double radius, DVec2 velocity = {});
SceneBody box(DVec2 position, DVec2 size, double angle = 0.0);
SceneBody fixed(SceneBody body);      // static
SceneBody kinematic(SceneBody body);  // of infinite mass, moving at its velocity
SceneBody ghost(SceneBody body);      // touches nothing

// Adds the body under the name b<index>, and returns its index.
int add(Scene& scene, SceneBody body);

// A static floor whose surface is y = 0, `width` m wide.
int add_floor(Scene& scene, double width = 400.0);

// Four static walls around a square of `inner` m.
void add_walls(Scene& scene, DVec2 middle, double inner);

// The world point as a hinge of two bodies, numbered as add() did.
void add_hinge(Scene& scene, int body_a, int body_b, DVec2 at);

// A rod between the centres of two bodies, as long as they are apart, or a spring with that rest length.
void add_rod(Scene& scene, int body_a, int body_b, DVec2 anchor_a);

std::string body_name(int index);

}  // namespace tumble::reference
