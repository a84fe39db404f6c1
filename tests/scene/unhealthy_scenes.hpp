// Valid scenes, each with one planted fault, and the body or joint at fault.
#pragma once

#include <string>
#include <vector>

namespace tumble::test {

struct UnhealthyScene {
    std::string fault;    // for messages
    std::string check;    // that must find it: a name of kHealthChecks
    std::string culprit;  // the body or joint that the finding must name
    std::string rest;     // members of the scene file after its bodies
    std::string bodies;   // JSON objects, besides those of every scene
    double seconds = 4.0;
    std::string world{};  // further members of the world
};

// A box or a ball, "more" being further members of the body.
inline std::string box(const std::string& name, const std::string& position, const std::string& size,
                       const std::string& material, const std::string& more = "") {
    return R"({"name": ")" + name + R"(", "position": )" + position + R"(, "shapes": [{"box": {"size": )" + size +
           R"(}, "material": ")" + material + R"("}])" + more + "}";
}
inline std::string ball(const std::string& name, const std::string& position, const std::string& radius,
                        const std::string& material, const std::string& more = "") {
    return R"({"name": ")" + name + R"(", "position": )" + position + R"(, "shapes": [{"circle": {"radius": )" +
           radius + R"(}, "material": ")" + material + R"("}])" + more + "}";
}

// Ten links on a hook, and what hangs below them.
inline std::string chain_bodies(const std::string& last) {
    return box("link", "[0, 9.75]", "[0.1, 0.5]", "wood",
               R"(, "repeat": {"grid": {"rows": 10, "spacing": [0, -0.5]}})") +
           ", " + last;
}
inline const std::string kChainJoints =
    R"("joints": [{"type": "revolute", "name": "top", "bodies": ["hook", "link[0]"], "anchor": [0, 10]},
       {"type": "revolute", "name": "hinge", "bodies": ["link[0]", "link[1]"], "anchors": [[0, -0.25], [0, 0.25]], "repeat": {"columns": 9}},
       {"type": "revolute", "name": "last", "bodies": ["link[9]", "weight"], "anchors": [[0, -0.25], [0, 0.5]]}])";

// Events that turn a body around eight times in 30 steps, the fewest that jitter has; the first is in the first step.
inline std::string shaking(const std::string& body) {
    std::string events;
    double speed = 0.15;
    for (const int step : {0, 4, 8, 12, 15, 19, 23, 27}) {
        events += std::string(events.empty() ? "" : ", ") + R"({"every": 0.5, "from": )" + std::to_string(step / 60.0) +
                  R"(, "body": ")" + body + R"(", "velocity": [)" + std::to_string(speed) + ", 0]}";
        speed = -speed;
    }
    return R"("timeline": [)" + events + "]";
}

inline std::vector<UnhealthyScene> unhealthy_scenes() {
    const std::string crate = box("crate", "[0, 0.5]", "[1, 1]", "wood");
    const std::string rows = R"(, "repeat": {"grid": {"rows": 3, "spacing": [0, 1]}})";
    const std::string floating = R"(, "gravity_scale": 0)";
    return {
        {"a body starts inside another", "overlap", "intruder", "",
         crate + ", " + box("intruder", "[0.3, 0.8]", "[1, 1]", "wood")},
        {"a body is spawned inside another", "overlap", "drop",
         R"("timeline": [{"at": 1, "spawn": )" + box("drop", "[0.2, 0.7]", "[1, 1]", "wood") + "}]", crate},
        {"a stack of too few steps", "overlap", "block[0]", "",
         box("block", "[5, 0.5]", "[1, 1]", "wood", R"(, "repeat": {"grid": {"rows": 20, "spacing": [0, 1]}})"), 4.0,
         R"(, "substeps": 1, "steps_per_second": 15)"},
        {"a stack of a mass ratio of 100 000", "overlap", "egg", "",
         box("egg", "[0, 0.5]", "[1, 1]", "foam") + ", " + box("anvil", "[0, 1.5]", "[1, 1]", "lead")},
        {"a press that does not stop", "overlap", "grape",
         R"("timeline": [{"at": 6.5, "body": "press", "velocity": [0, 0]}])",
         box("press", "[0, 4]", "[4, 1]", "wood", R"(, "type": "kinematic", "velocity": [0, -0.5])") + ", " +
             box("grape", "[0, 0.5]", "[1, 1]", "wood"),
         9.0},
        {"a shot that passes through its target", "tunnelling", "shot", "",
         ball("shot", "[-5, 8]", "0.1", "wood", floating + R"(, "velocity": [150, 0])") + ", " +
             ball("target", "[0.7, 8]", "0.15", "wood", floating),
         4.0, R"(, "impacts": "at_step_end")"},
        {"a ball that rolls off the floor", "lost", "roller", "",
         ball("roller", "[18, 0.5]", "0.5", "wood", R"(, "velocity": [3, 0], "angular_velocity": -344)"), 6.0},
        {"a chain whose open side is above", "lost", "sinker", "",
         R"({"name": "terrain", "type": "static", "shapes": [{"chain": {"points": [[30, 0], [50, 0]]}}]}, )" +
             ball("sinker", "[40, -1]", "0.5", "wood") + ", " + crate},
        {"a crate on a table that shakes", "jitter", "shaken[0]",
         R"("timeline": [{"every": 0.0333333333, "body": "table", "velocity": [0.3, 0]},
            {"every": 0.0333333333, "from": 0.0166666667, "body": "table", "velocity": [-0.3, 0]}])",
         box("table", "[0, 0.5]", "[4, 1]", "rubber", R"(, "type": "kinematic")") + ", " +
             box("shaken", "[0, 1.5]", "[1, 1]", "rubber", rows)},
        {"a pot that slips on a tray, with a slow step between its directions", "jitter", "pot",
         R"("timeline": [{"every": 0.0666666667, "body": "tray", "velocity": [0.22, 0]},
            {"every": 0.0666666667, "from": 0.0333333333, "body": "tray", "velocity": [-0.22, 0]}])",
         box("tray", "[1, 0.4]", "[5, 0.4]", "grip", R"(, "type": "kinematic")") + ", " +
             box("pot", "[1, 1]", "[0.8, 0.8]", "grip")},
        {"a slider that shakes eight times in half a second", "jitter", "slider",
         R"("joints": [{"type": "prismatic", "bodies": ["hook", "slider"], "anchors": [[0, 0], [0, 0]], "axis": [1, 0]}], )" +
             shaking("slider"),
         box("slider", "[0, 10]", "[0.8, 0.8]", "wood", floating)},
        {"a chain of too few steps under a large gravity", "jitter", "link[5]",
         R"("joints": [{"type": "revolute", "name": "top", "bodies": ["post", "link[0]"], "anchors": [[0, 0], [-0.25, 0]]},
            {"type": "revolute", "name": "hinge", "bodies": ["link[0]", "link[1]"], "anchors": [[0.25, 0], [-0.25, 0]], "repeat": {"columns": 7}},
            {"type": "revolute", "name": "end", "bodies": ["link[7]", "floor"], "anchors": [[0.25, 0], [3, 0.5]]}])",
         ball("post", "[0, 8]", "0.1", "wood", R"(, "type": "static")") + ", " +
             box("link", "[0.25, 8]", "[0.5, 0.1]", "wood",
                 R"(, "repeat": {"grid": {"columns": 8, "spacing": [0.5, 0]}})"),
         8.0, R"(, "gravity": [0, -1000], "substeps": 1, "steps_per_second": 15)"},
        {"a chain with a weight that is far too heavy", "joint_error", "last", kChainJoints,
         chain_bodies(ball("weight", "[0, 4.5]", "0.5", "lead"))},
        {"a chain of too few sub-steps", "joint_error", "top", kChainJoints,
         chain_bodies(ball("weight", "[0, 4.5]", "0.5", "stone")), 4.0, R"(, "substeps": 1, "steps_per_second": 20)"},
        {"a joint whose anchors start apart", "joint_error", "hinge",
         R"("joints": [{"type": "revolute", "name": "hinge", "bodies": ["hook", "door"], "anchors": [[0, 0], [-0.5, 0.5]]}])",
         box("door", "[2, 7]", "[1, 1]", "wood")},
        {"a joint that starts beyond its limits", "joint_error", "elbow",
         R"("joints": [{"type": "revolute", "name": "elbow", "bodies": ["hook", "arm"], "anchor": [0, 10], "reference_angle": 90, "limits": [-30, 30]}])",
         box("arm", "[1, 10]", "[2, 0.2]", "wood")},
        {"a heavy body on a light one", "mass_ratio", "cushion", "",
         box("cushion", "[0, 0.5]", "[1, 1]", "wood") + ", " + box("safe", "[0, 1.5]", "[1, 1]", "iron")},
        {"a heavy table on two light legs", "mass_ratio", "leg[0]", "",
         box("leg", "[-1, 0.5]", "[0.3, 1]", "foam", R"(, "repeat": {"grid": {"columns": 2, "spacing": [2, 0]}})") +
             ", " + box("top", "[0, 1.03]", "[3, 0.06]", "iron")},
        {"a body that must not sleep", "sleepless", "guest", "",
         box("crate", "[0, 0.5]", "[1, 1]", "wood", rows) + ", " +
             box("guest", "[0, 3.5]", "[1, 1]", "wood", R"(, "allow_sleep": false)")},
        {"a balloon that drifts", "sleepless", "balloon", "",
         crate + ", " + ball("balloon", "[3, 5]", "0.5", "wood", floating + R"(, "velocity": [0.01, 0])")},
        {"a motor under a crate that rests on its drums", "sleepless", "axle[0]",
         R"("joints": [{"type": "revolute", "name": "axle", "bodies": ["floor", "drum[0]"], "anchors": [[0, 1.5], [0, 0]],
            "motor": {"speed": 90, "max_torque": 50}, "repeat": {"columns": 2, "spacing": [2, 0]}}])",
         ball("drum", "[0, 1]", "0.5", "ice", R"(, "repeat": {"grid": {"columns": 2, "spacing": [2, 0]}})") + ", " +
             box("crate", "[1, 1.75]", "[3.4, 0.5]", "ice")},
        {"a conveyor that creeps", "sleepless", "slab", "",
         box("slab", "[0, 1]", "[30, 0.5]", "ice", R"(, "type": "kinematic", "velocity": [0.02, 0])") + ", " +
             box("crate", "[0, 1.75]", "[1, 1]", "ice")},
        {"a velocity beyond the speed limit", "speed_limit", "comet", "",
         crate + ", " + ball("comet", "[0, 20]", "0.5", "wood", R"(, "velocity": [5000, 100])")},
        {"a rotation beyond its limit", "speed_limit", "propeller", "",
         box("propeller", "[0, 5]", "[4, 0.2]", "wood", floating + R"(, "angular_velocity": 20000)")},
        {"a kick", "energy", "puck", R"("timeline": [{"at": 1, "body": "puck", "impulse": [200, 0]}])",
         crate + ", " + ball("puck", "[3, 5]", "0.5", "wood", floating)},
        {"a tiny body", "size", "dust", "", crate + ", " + ball("dust", "[3, 0.001]", "0.001", "wood")},
        {"a huge body", "size", "moon", "", crate + ", " + box("moon", "[200, 160]", "[300, 300]", "wood", floating)},
        {"a spring too stiff for the step", "stiff_spring", "bungee",
         R"("joints": [{"type": "distance", "name": "bungee", "bodies": ["hook", "bob"], "anchors": [[0, 0], [0, 0]], "spring": {"hertz": 200, "damping_ratio": 0.1}}])",
         ball("bob", "[0, 8]", "0.5", "wood")},
        {"a motor that fights a limit", "motor", "wrist",
         R"("joints": [{"type": "revolute", "name": "wrist", "bodies": ["hook", "hand"], "anchor": [0, 10], "limits": [-30, 30], "motor": {"speed": 200, "max_torque": 100000}}])",
         box("hand", "[1, 10]", "[2, 0.2]", "wood")},
    };
}

// The scene file.
inline std::string text_of(const UnhealthyScene& scene) {
    return R"({"format": 1, "name": "unhealthy", "world": {"duration": )" + std::to_string(scene.seconds) +
           scene.world +
           R"(}, "materials": {"wood": {}, "foam": {"density": 0.1}, "stone": {"density": 3}, "iron": {"density": 200},
           "lead": {"density": 10000}, "ice": {"friction": 0}, "rubber": {"friction": 2},
           "grip": {"friction": 1.5}}, "bodies": [
           {"name": "floor", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [40, 1]}}]},
           {"name": "hook", "type": "static", "position": [0, 10], "shapes": [{"circle": {"radius": 0.1}}]}, )" +
           scene.bodies + "]" + (scene.rest.empty() ? "" : ", " + scene.rest) + "}";
}

}  // namespace tumble::test
