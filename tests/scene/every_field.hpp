// Valid scenes that together use every field of the format.
#pragma once

#include <string>
#include <vector>

namespace tumble::test {

inline std::vector<std::string> scenes_with_every_field() {
    const std::string bodies =
        R"("bodies": [{"name": "ground", "type": "static", "shapes": [{"box": {"size": [40, 1]}}]}, {"name": "a", "position": [0, 5], "shapes": [{"circle": {"radius": 1}}]}], )";
    const std::string joint = bodies + R"("joints": [{"bodies": ["ground", "a"], )";
    const std::string event =
        bodies +
        R"("joints": [{"type": "mouse", "name": "pull", "bodies": ["ground", "a"], "anchor": [0, 5], "max_force": 10},
                     {"type": "wheel", "name": "wheel", "bodies": ["ground", "a"], "anchor": [0, 5], "axis": [0, 1], "motor": {"speed": 1, "max_torque": 2}}], "timeline": [{"at": 1, )";
    const std::string claim_start =
        bodies +
        R"("joints": [{"type": "weld", "name": "weld", "bodies": ["ground", "a"], "anchor": [0, 5]}], "expect": [{)";
    const std::string shape = R"("bodies": [{"shapes": [{)";
    std::vector<std::string> scenes = {
        R"("$schema": "scene.schema.json", "name": "all", "description": "Everything.",
           "world": {"gravity": [0, -10], "steps_per_second": 60, "substeps": 4, "duration": 5, "seed": 1, "sleeping": true, "continuous": true, "joints": "direct", "impacts": "in_order", "scale": 1},
           "camera": {"center": [0, 4], "height": 12, "follow": "a",
                      "style": {"theme": "dark", "outlines": false, "hatching": true, "shadows": true},
                      "keys": [{"time": 0, "center": [1, 2], "height": 9}, {"time": 2, "follow": ["a"], "height": 3}],
                      "notes": [{"text": "here", "position": [0, 1], "from": 1, "until": 2}, {"text": "a", "above": "a"}],
                      "card": {"title": "All", "text": "Everything.", "until": 1}},
           "materials": {"ice": {"density": 1, "friction": 0.1, "restitution": 0.2, "rolling_resistance": 0.1, "tangent_speed": 1, "color": "#9bd"}},
           "bodies": [{"name": "a", "type": "dynamic", "position": [0, 1], "angle": 1, "velocity": [1, 2], "angular_velocity": 3, "linear_damping": 0.1,
                       "angular_damping": 0.2, "gravity_scale": 1, "bullet": true, "awake": true, "fixed_rotation": false, "lock_x": false, "lock_y": false,
                       "enabled": true, "allow_sleep": true, "allow_fast_rotation": true, "mass": {"mass": 1, "center": [0, 0], "inertia": 1}, "trail": true, "skin": true,
                       "shapes": [{"circle": {"radius": 1, "center": [0, 0]}, "material": "ice", "filter": {"category": 1, "mask": 3, "group": 0}, "sensor": false, "custom": 1}],
                       "images": [{"file": "a.png", "center": [0, 1], "angle": 30, "height": 2, "width": 3, "flip": true, "opacity": 0.5, "order": -1}],
                       "custom": [1]}],
           "custom": {"any": "thing"})",
        R"("include": [{"file": "part.json", "position": [1, 2], "angle": 30, "prefix": "p/"}])",
        shape + R"("capsule": {"from": [0, 0], "to": [1, 0], "radius": 0.5}}]}])",
        shape + R"("box": {"size": [2, 1], "radius": 0.1, "center": [0, 1], "angle": 5}}]}])",
        shape + R"("polygon": {"vertices": [[0, 0], [1, 0], [0, 1]], "radius": 0.1}}]}])",
        shape + R"("segment": {"from": [0, 0], "to": [1, 0]}}]}])",
        shape + R"("chain": {"points": [[0, 0], [1, 0], [1, 1]], "loop": true, "two_sided": true}}]}])",
        shape + R"("outline": {"points": [[0, 0], [1, 0], [0, 1]]}}]}])",
        R"("bodies": [{"name": "node", "repeat": {"grid": {"columns": 3, "rows": 2}}}],
           "joints": [{"type": "filter", "bodies": ["node[0]", "node[1]"], "repeat": {"columns": 2, "rows": 2, "row_step": 3}}])",
        R"("bodies": [{"name": "beam", "type": "static"}, {"name": "bob", "repeat": {"grid": {"columns": 2}}, "shapes": [{"circle": {"radius": 1}}]}],
           "joints": [{"type": "distance", "bodies": ["beam", "bob[0]"], "anchors": [[0, 5], [0, 0]], "repeat": {"columns": 2, "spacing": [1, 0]}}])",
        R"("bodies": [{"repeat": {"grid": {"columns": 2, "rows": 3, "spacing": [1, 1], "angle": 5}}},
                      {"repeat": {"pyramid": {"base": 3, "spacing": [1, 1], "angle": 5}}},
                      {"repeat": {"ring": {"count": 3, "radius": 2, "turn": true, "angle": 5}}},
                      {"repeat": {"scatter": {"count": 3, "size": [9, 9], "turn": true, "separation": 0.1, "angle": 5}}}])",
        joint + R"("name": "j", "type": "revolute", "anchor": [0, 5], "reference_angle": 0, "limits": [-10, 10],
                   "motor": {"speed": 5, "max_torque": 2}, "spring": {"hertz": 2, "damping_ratio": 0.5}, "break_force": 100, "break_torque": 100,
                   "collide_connected": true, "custom": 1}])",
        joint +
            R"("type": "distance", "anchors": [[0, 0], [0, 0]], "length": 5, "limits": [1, 9], "motor": {"speed": 5, "max_force": 2}}])",
        joint + R"("type": "prismatic", "anchor": [0, 5], "axis": [1, 0]}])",
        joint + R"("type": "weld", "anchor": [0, 5], "angular_spring": {"hertz": 2, "damping_ratio": 0.5}}])",
        joint +
            R"("type": "pulley", "anchors": [[0, 2], [0, 0]], "ground_anchors": [[0, 9], [1, 9]], "length": 12, "ratio": 2}])",
        joint +
            R"("type": "revolute", "name": "hinge", "anchor": [0, 5]}, {"bodies": ["ground", "a"], "type": "prismatic", "name": "rail", "anchor": [0, 5], "axis": [0, 1]},
                   {"type": "gear", "joints": ["hinge", "rail"], "ratio": -0.5, "break_torque": 3, "collide_connected": true}])",
        joint +
            R"("type": "motor", "anchor": [0, 5], "velocity": [1, 0], "angular_velocity": 3, "max_force": 10, "max_torque": 10}])",
        bodies +
            R"("timeline": [{"every": 0.5, "from": 1, "until": 2, "spawn": {"name": "drop", "position": [9, 9]}}, {"at": 1, "gravity": [0, 1]}])",
    };
    for (const char* action : {R"("body": "a", "impulse": [1, 0])", R"("body": "a", "angular_impulse": 1)",
                               R"("body": "a", "force": [1, 0], "until": 2)", R"("body": "a", "torque": 1)",
                               R"("body": "a", "velocity": [1, 0])", R"("body": "a", "angular_velocity": 1)",
                               R"("joint": "wheel", "motor_speed": 3)", R"("joint": "pull", "target": [1, 1])",
                               R"("despawn": "a")", R"("release": "pull")"})
        scenes.push_back(event + action + "}]");
    for (const char* claim :
         {R"("at_rest_by": 2)", R"("max_penetration": 0.1)",
          R"("max_joint_error": 0.1, "joint": "weld", "from": 1, "until": 2)", R"("max_energy_gain": 5)",
          R"("body": "a", "inside": [[0, 0], [1, 1]], "frame": {"position": [1, 2], "angle": 30})",
          R"("body": "a", "outside": [[0, 0], [1, 1]], "when": "always")", R"("body": "a", "height": [0, 1], "at": 1)",
          R"("body": "a", "speed": [0, 1])", R"("body": "a", "angle": [-5, 5])", R"("body": "a", "touches": "ground")",
          R"("body": "a", "never_touches": "ground")", R"("count": [0, 1], "region": [[0, 0], [1, 1]])",
          R"("event_count": [0, 9], "event": "contact_begin")", R"("state_hash": "0123456789abcdef")",
          R"("that": "a.y > 1", "before": "time > 1")", R"("max_ms_per_step": 2)",
          R"("max_time_ratio": 2, "reference": "other.json")", R"("picture": "golden.png", "tolerance": 2)"})
        scenes.push_back(claim_start + claim + "}]");
    const std::string reaction =
        bodies +
        R"~("timeline": [{"when": "touching(a, ground)", "delay": 0.5, "frame": {"position": [1, 2], "angle": 3}, )~";
    scenes.push_back(reaction + R"("stop": true}])");
    for (std::string& scene : scenes) scene = R"({"format": 1, )" + scene + "}";
    return scenes;
}

}  // namespace tumble::test
