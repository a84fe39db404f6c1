#include "python/bindings/env_worlds.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::python {

namespace {

// splitmix64 (Steele, Lea, Flood 2014).
std::uint64_t scramble(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// In [0, 1).
double uniform(std::uint64_t seed, std::uint64_t world, std::uint64_t episode, std::uint64_t draw) {
    const std::uint64_t bits = scramble(scramble(scramble(scramble(seed) ^ world) ^ episode) ^ draw);
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

void randomize(World& world, const RandomPlan& plan, float value) {
    const BodyState state = world.state(plan.body);
    switch (plan.kind) {
        case RandomKind::velocity_x:
            return world.set_velocity(plan.body, state.velocity + Vec2{value, 0.0f}, state.angular_velocity);
        case RandomKind::velocity_y:
            return world.set_velocity(plan.body, state.velocity + Vec2{0.0f, value}, state.angular_velocity);
        case RandomKind::angular_velocity:
            return world.set_velocity(plan.body, state.velocity, state.angular_velocity + value);
        case RandomKind::gravity_scale:
            return world.set_gravity_scale(plan.body, world.definition(plan.body).gravity_scale + value);
        case RandomKind::impulse_x: return world.apply_impulse(plan.body, {value, 0.0f});
        case RandomKind::impulse_y: return world.apply_impulse(plan.body, {0.0f, value});
    }
}

void apply(World& world, const ActionPlan& plan, float entry) {
    const float part = 0.5f * (std::clamp(entry, -1.0f, 1.0f) + 1.0f);
    const float value = plan.low + part * (plan.high - plan.low);
    switch (plan.kind) {
        case ActionKind::force: return world.apply_force(plan.body, value * plan.axis);
        case ActionKind::thrust: {
            const Pose pose = world.state(plan.body).pose;
            return world.apply_force(plan.body, value * rotate(pose.rotation, plan.axis),
                                     transform_point(pose, plan.point));
        }
        case ActionKind::torque: return world.apply_torque(plan.body, value);
        case ActionKind::motor_speed: return world.set_motor_speed(plan.joint, value);
        case ActionKind::motor_effort:
            return world.set_motor(plan.joint, value < 0.0f ? -plan.speed : plan.speed, std::abs(value));
    }
}

double free_part(const World& world, const ObservedPlan& plan) {
    const Pose pose = world.state(plan.body).pose;
    const Vec2 way = plan.turns ? rotate(pose.rotation, plan.axis) : plan.axis;
    QueryFilter filter;
    filter.except = plan.body;
    const auto hit = world.cast_ray(transform_point(pose, plan.point), DVec2(way), filter);
    return hit ? hit->fraction : 1.0;
}

bool touches(const std::vector<ContactPoint>& contacts, BodyId body, BodyId other) {
    const auto is_other = [&](BodyId id) { return other == BodyId{} || id == other; };
    return std::any_of(contacts.begin(), contacts.end(), [&](const ContactPoint& contact) {
        return contact.normal_impulse > 0.0f && ((contact.body_a == body && is_other(contact.body_b)) ||
                                                 (contact.body_b == body && is_other(contact.body_a)));
    });
}

double measure(const World& world, const std::vector<ContactPoint>& contacts, const ObservedPlan& plan) {
    switch (plan.kind) {
        case ObservedKind::x: return world.state(plan.body).pose.position.x;
        case ObservedKind::y: return world.state(plan.body).pose.position.y;
        case ObservedKind::angle: return angle(world.state(plan.body).pose.rotation);
        case ObservedKind::velocity_x: return double{world.state(plan.body).velocity.x};
        case ObservedKind::velocity_y: return double{world.state(plan.body).velocity.y};
        case ObservedKind::angular_velocity: return double{world.state(plan.body).angular_velocity};
        case ObservedKind::joint_position: return world.joint_motion(plan.joint).position;
        case ObservedKind::joint_speed: return world.joint_motion(plan.joint).speed;
        case ObservedKind::touching: return touches(contacts, plan.body, plan.other) ? 1.0 : 0.0;
        case ObservedKind::ray: return free_part(world, plan);
    }
    return 0.0;
}

}  // namespace

EnvWorlds::EnvWorlds(std::vector<std::byte> snapshot, EnvPlan plan, std::size_t count, int threads, std::uint64_t seed)
    : snapshot_(std::move(snapshot)),
      plan_(std::move(plan)),
      needs_contacts_(std::any_of(plan_.observations.begin(), plan_.observations.end(),
                                  [](const ObservedPlan& o) { return o.kind == ObservedKind::touching; })),
      seed_(seed),
      worlds_(count),
      episodes_(count, 0),
      workers_(threads) {
    for (std::optional<World>& world : worlds_) world = World::load(snapshot_);
}

void EnvWorlds::seed(std::uint64_t seed) {
    seed_ = seed;
    std::fill(episodes_.begin(), episodes_.end(), 0);
}

void EnvWorlds::reset_one(std::size_t index) {
    World& world = worlds_[index].emplace(World::load(snapshot_));
    for (std::size_t i = 0; i < plan_.randoms.size(); ++i) {
        const RandomPlan& random = plan_.randoms[i];
        const double part = uniform(seed_, index, episodes_[index], i);
        randomize(world, random, static_cast<float>(double{random.low} + part * double{random.high - random.low}));
    }
    ++episodes_[index];
}

void EnvWorlds::act(World& world, std::span<const float> action) const {
    for (std::size_t i = 0; i < plan_.actions.size(); ++i) apply(world, plan_.actions[i], action[i]);
}

void EnvWorlds::observe(const World& world, std::span<float> out) const {
    const std::vector<ContactPoint> contacts = needs_contacts_ ? world.contacts() : std::vector<ContactPoint>{};
    for (std::size_t i = 0; i < plan_.observations.size(); ++i) {
        const ObservedPlan& plan = plan_.observations[i];
        out[i] = static_cast<float>((measure(world, contacts, plan) - double{plan.offset}) * double{plan.scale});
    }
}

void EnvWorlds::step(std::span<const float> actions, std::span<float> observations, std::span<std::uint8_t> failed) {
    const std::size_t acts = plan_.actions.size(), seen = plan_.observations.size();
    workers_.run(count(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            World& world = *worlds_[i];
            const std::span<float> out = observations.subspan(i * seen, seen);
            failed[i] = 0;
            try {
                // Forces act during one step only, so that every step gets them.
                for (int k = 0; k < plan_.frame_skip; ++k) {
                    act(world, actions.subspan(i * acts, acts));
                    world.step();
                }
                observe(world, out);
            } catch (const SimulationDiverged&) {
                failed[i] = 1;
                std::fill(out.begin(), out.end(), 0.0f);
            }
        }
    });
}

void EnvWorlds::reset(std::span<const std::uint8_t> mask, std::span<float> observations) {
    const std::size_t seen = plan_.observations.size();
    workers_.run(count(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (mask[i] == 0) continue;
            reset_one(i);
            observe(*worlds_[i], observations.subspan(i * seen, seen));
        }
    });
}

}  // namespace tumble::python
