// The example of format 1: everything that a scene file can contain, once.
#pragma once

namespace tumble::test {

inline constexpr const char* kExample = R"scene({
  "$schema": "scene.schema.json",
  "format": 1,
  "name": "seesaw",
  "description": "A ball tips the plank; the crates stand by.",
  "world": {"gravity": [0, -10], "steps_per_second": 60, "substeps": 4, "duration": 5, "seed": 1, "sleeping": true, "continuous": true},
  "camera": {"center": [0, 4], "height": 12, "follow": "ball"},          // default: everything in view
  "materials": {"ice": {"density": 0.9, "friction": 0.02, "restitution": 0.1, "rolling_resistance": 0, "tangent_speed": 0, "color": "#9bd"}},
  "bodies": [
    {"name": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [40, 1]}}]},
    {"name": "plank", "position": [0, 1], "shapes": [{"box": {"size": [8, 0.2]}}]},
    {"name": "ball", "position": [3, 6], "angle": 30, "velocity": [0, 0], "angular_velocity": 90,
     "shapes": [{"circle": {"radius": 0.5}, "material": "ice"}]},
    {"name": "crate", "position": [-12, 0.5], "repeat": {"pyramid": {"base": 5, "spacing": [1.05, 1]}}, "shapes": [{"box": {"size": [1, 1], "radius": 0.02}}]}
  ],
  "joints": [{"type": "revolute", "name": "hinge", "bodies": ["ground", "plank"], "anchor": [0, 1], "limits": [-20, 20],
              "motor": {"speed": 90, "max_torque": 50}, "spring": {"hertz": 2, "damping_ratio": 0.5}, "break_force": 900, "collide_connected": false}],
  "timeline": [{"at": 1.5, "body": "ball", "impulse": [3, 0]},
               {"every": 0.25, "until": 2, "spawn": {"name": "drop", "position": [5, 9], "shapes": [{"capsule": {"from": [-0.3, 0], "to": [0.3, 0], "radius": 0.2}}]}}],
  "expect": [{"at_rest_by": 5}, {"max_penetration": 0.02}, {"body": "ball", "inside": [[-1, 0], [1, 2]], "at": 3}],
  "custom": {"author": "anything a user wants to keep; also on bodies, shapes and joints"}
}
)scene";

}  // namespace tumble::test
