// Many copies of one world for learning: acted on, stepped, observed and reset in one call.
//
// The plan of an environment is resolved before: bodies and joints are ids, equal in all copies. All worlds start from
// one snapshot, then each draws its random values from its own seed and the number of its episode, so that an episode
// does not depend on the other worlds or on the number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "python/bindings/workers.hpp"
#include "tumble/world.hpp"

namespace tumble::python {

// What one entry of an action does; an entry is clipped to [-1, 1] and maps to [low, high].
enum class ActionKind : std::uint8_t {
    force,        // on a body at its origin, along `axis` (world), N
    thrust,       // the same along `axis` in body coordinates, at `point` in body coordinates
    torque,       // on a body, N m
    motor_speed,  // of a joint
    motor_effort  // of a joint: turns at `speed` in the direction of the sign, with the torque or force |value|
};

struct ActionPlan {
    ActionKind kind{};
    BodyId body{};
    JointId joint{};
    Vec2 axis{}, point{};
    float speed = 0.0f;
    float low = 0.0f, high = 0.0f;
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
    touching,  // 1 if the body touches `other`, or any body if it has none
    ray        // the part of a ray from `point` along `axis` that is free, 0 to 1; in coordinates of the body
};

// One entry of an observation: (value - offset) * scale.
struct ObservedPlan {
    ObservedKind kind{};
    BodyId body{}, other{};
    JointId joint{};
    Vec2 axis{}, point{};
    bool turns = false;  // the ray turns with the body
    float offset = 0.0f, scale = 1.0f;
};

// Drawn from [low, high] at each reset, and added to the value of the snapshot.
enum class RandomKind : std::uint8_t { velocity_x, velocity_y, angular_velocity, gravity_scale, impulse_x, impulse_y };

struct RandomPlan {
    RandomKind kind{};
    BodyId body{};
    float low = 0.0f, high = 0.0f;
};

struct EnvPlan {
    std::vector<ActionPlan> actions;
    std::vector<ObservedPlan> observations;
    std::vector<RandomPlan> randoms;
    int frame_skip = 1;
};

class EnvWorlds {
public:
    EnvWorlds(std::vector<std::byte> snapshot, EnvPlan plan, std::size_t count, int threads, std::uint64_t seed);

    std::size_t count() const { return worlds_.size(); }
    const EnvPlan& plan() const { return plan_; }
    World& world(std::size_t index) { return *worlds_.at(index); }

    // Acts ([count, actions]), steps all worlds frame_skip times and writes the observations ([count, observations]). A
    // world that diverges has an entry 1 in `failed` and the observations 0.
    void step(std::span<const float> actions, std::span<float> observations, std::span<std::uint8_t> failed);

    // Starts a new episode in the worlds whose entry in `mask` is not 0, and writes their observations.
    void reset(std::span<const std::uint8_t> mask, std::span<float> observations);

    // The next reset() begins with episode 0 of a seed again.
    void seed(std::uint64_t seed);

private:
    void reset_one(std::size_t index);
    void act(World& world, std::span<const float> action) const;
    void observe(const World& world, std::span<float> out) const;

    std::vector<std::byte> snapshot_;
    EnvPlan plan_;
    bool needs_contacts_ = false;
    std::uint64_t seed_ = 0;
    std::vector<std::optional<World>> worlds_;
    std::vector<std::uint64_t> episodes_;  // begun in each world
    Workers workers_;
};

}  // namespace tumble::python
