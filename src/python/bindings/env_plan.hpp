// What an environment acts on, observes and draws at random: bodies and joints are ids, equal in all copies of a world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/world.hpp"

namespace tumble::python {

// What one entry of an action does; an entry is clipped to [-1, 1] and maps to [low, high].
enum class ActionKind : std::uint8_t {
    force,         // on a body at its origin, along `axis` (world), N
    thrust,        // the same along `axis` in body coordinates, at `point` in body coordinates
    torque,        // on a body, N m
    motor_speed,   // of a joint
    motor_effort,  // of a joint: turns at `speed` in the direction of the sign, with the torque or force |value|
    velocity,      // of a body, the component along `axis` (world), m/s
    spin,          // of a body, rad/s
    target         // of a mouse joint: the component along `axis` (world) from `point`, m
};

struct ActionPlan {
    ActionKind kind{};
    BodyId body{};
    JointId joint{};
    Vec2 axis{}, point{};
    float speed = 0.0f;
    float low = 0.0f, high = 0.0f;
    std::string pointer{};  // of its entry in custom.env: "/actions/0"
};

enum class ObservedKind : std::uint8_t {
    x,
    y,
    angle,
    velocity_x,
    velocity_y,
    angular_velocity,
    joint_position,
    joint_speed,
    touching,      // 1 if the body touches `other`, or any body if it has none
    ray,           // the part of a ray from `point` along `axis` that is free, 0 to 1; in coordinates of the body
    value,         // of an expression, also of previous observations, actions, and the observations before it
    contact_force  // the sum of the normal forces between the body and `other`, or all bodies, in the last step, N
};

// One entry of an observation: (value - offset) * scale.
struct ObservedPlan {
    ObservedKind kind{};
    BodyId body{}, other{};
    JointId joint{};
    Vec2 axis{}, point{};
    bool turns = false;          // the ray turns with the body
    std::uint64_t mask = ~0ull;  // the categories of shapes that the ray sees
    float offset = 0.0f, scale = 1.0f;
    std::string expression{};
    std::string pointer{};  // of its entry in custom.env: "/observations/3"
};

// Drawn from [low, high] at each reset. The quantities of the motion are added to those of the start; the last three
// multiply them.
enum class RandomKind : std::uint8_t {
    x,
    y,
    angle,
    velocity_x,
    velocity_y,
    angular_velocity,
    gravity_scale,
    impulse_x,
    impulse_y,
    mass,
    friction,
    restitution
};

struct RandomPlan {
    RandomKind kind{};
    BodyId body{};
    float low = 0.0f, high = 0.0f;
};

// An image that is observed: pixels, or the label of the body that each pixel shows. What its camera leaves out is that
// of the scene's camera.
struct ImagePlan {
    bool is_mask = false;
    int columns = 0, rows = 0;
    std::optional<DVec2> center{};   // m
    std::optional<double> height{};  // m of the world from the lower to the upper edge
    std::string follow{};            // name of a body
};

struct EnvPlan {
    std::vector<ActionPlan> actions;
    std::vector<float> choices;  // rows of actions; none: the agent gives rows itself
    std::vector<ObservedPlan> observations;
    std::vector<ImagePlan> images;
    std::vector<RandomPlan> randoms;
    std::vector<std::string> observation_names, action_names;
    std::string reward = "0", done = "false";  // expressions; of the names, previous_NAME and action_NAME too
    int frame_skip = 1;
    std::int64_t steps = 0;      // of an episode; 0: no limit
    std::string text{}, file{};  // what declares it: for errors with their line
};

}  // namespace tumble::python
